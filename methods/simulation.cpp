// SPDX-License-Identifier: BSD-3-Clause
#include "methods/simulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Simulation::Simulation(Model model, const Setup& setup)
    : setup_(setup), model_(std::move(model)), system_(make_system(model_, setup.formulation)) {
    const Method& entry = method(setup.method);
    const ProjectionMethod& projector = kreisel::projection(setup.projection);
    integrator_ = entry.bind(*system_, with_defaults(setup.options, entry.description.options));
    projection_ = projector.make(*system_, with_defaults(setup.projection_options, projector.description.options));
    y_ = initial_state(*system_, model_);
}

std::vector<BodyState> Simulation::bodies() const {
    std::vector<BodyState> states(model_.bodies.size());
    system_->read(y_.data(), states.data());
    return states;
}

Status Simulation::restart(const Real& t, const std::vector<Real>& y) {
    t_ = t, y_ = y;
    return restart();
}

Status Simulation::fail(Status status, const char* part, const std::string& who) {
    const std::string reason = system_->reason(status);
    failed_part_ = part + who;
    failure_ = failed_part_ + ": " + name(status) + (reason.empty() ? "" : ", " + reason);
    return status;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
