// SPDX-License-Identifier: BSD-3-Clause
#include "engine/structure_probe.hpp"

#include <algorithm>

#include "engine/step_times.hpp"
#include "mechanics/model/scales.hpp"
#include "methods/contract/method.hpp"
#include "problems/problem.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Why the steps of a cell are not maps of states; empty if they are.
std::string why_no_map(const Cell& cell) {
    if (cell.tolerance > 0) return "steps to a tolerance have no size of their own";
    const auto every = cell.projection_options.find("every");
    if (every != cell.projection_options.end() && every->second != OptionValue(1L))
        return "not every step is followed by a projection";
    return method(cell.method).description.keeps_memory ? "a step depends on earlier ones" : "";
}

}  // namespace

StructureProbe::StructureProbe(const Cell& cell, const Setup& setup)
    : metrics_(cell.metrics), simulation_(problem(cell.problem).build(Parameters(cell.parameters)), setup) {
    if (const std::string reason = why_no_map(cell); !reason.empty()) {
        metrics_.decline(reason);
        return;
    }
    const Real begin = cell.begin ? from_text(cell.begin->t.text) : Real(0);
    h_ = StepTimes(begin, decimal(cell.t_end), cell.steps).h();
    step_ = [this](const Real& t, const Real& h, Real* y) {
        state_.assign(y, y + state_.size());
        Status status = simulation_.restart(t, state_);
        if (status == Status::ok) status = simulation_.step(h);
        std::copy(simulation_.state().begin(), simulation_.state().end(), y);
        return status;
    };
}

void StructureProbe::observe(const Real& t, const std::vector<Real>& y) {
    if (h_ == 0) return;
    metrics_.observe({simulation_.system(), step_, extent(simulation_.model()), t, h_, y.data()});
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
