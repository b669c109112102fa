// SPDX-License-Identifier: BSD-3-Clause
#include "methods/simulation.hpp"

#include "mechanics/model/scales.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Simulation::Simulation(Model model, const Setup& setup)
    : setup_(setup), model_(std::move(model)), system_(make_system(model_, setup.formulation)) {
    const Method& entry = method(setup.method);
    const ProjectionMethod& projector = kreisel::projection(setup.projection);
    const OptionValues how = with_defaults(setup.projection_options, projector.description.options);
    projection_ = projector.make(*system_, how);
    changed_ = projector.changed(*system_, how);
    System& integrated = changed_ ? *changed_ : *system_;
    if (SingularPassage::is_possible(model_)) {
        auto passage = std::make_unique<SingularPassage>(*system_, model_, std::move(projection_));
        passage_ = passage.get();
        projection_ = std::move(passage);
    }
    const OptionValues options = with_defaults(setup.options, entry.description.options);
    if (setup.tolerance > 0)
        stepper_ =
            bind_stepper(entry, integrated, *projection_, {setup.tolerance, extent(model_), setup.controller}, options);
    else
        integrator_ = entry.bind(integrated, options);
    y_ = initial_state(*system_, model_);
}

Simulation::Simulation(SimulationParts parts, Model model)
    : setup_{.method = std::move(parts.method), .projection = std::move(parts.projector)},
      model_(std::move(model)),
      system_(std::move(parts.system)),
      changed_(std::move(parts.changed)),
      integrator_(std::move(parts.integrator)),
      projection_(std::move(parts.projection)),
      y_(initial_state(*system_, model_)) {}

std::vector<BodyState> Simulation::bodies() const {
    std::vector<BodyState> states(model_.bodies.size());
    system_->read(y_.data(), states.data());
    return states;
}

Status Simulation::restart(const Real& t, const std::vector<Real>& y) {
    move_to(t, y);
    return restart();
}

Status Simulation::restart() {
    projection_->start();
    const Status status = integrator_ ? integrator_->start(t_, y_.data()) : Status::ok;
    return status == Status::ok ? status : fail(status, "start", system_->reason(status));
}

Status Simulation::restart_to(const Real& t_end) {
    const Status status = stepper_->start(t_, t_end, y_.data());
    return status == Status::ok ? status : fail(status, "start", system_->reason(status));
}

Status Simulation::fail(Status status, const std::string& part, const std::string& reason) {
    failed_part_ = part, failure_reason_ = reason;
    failure_ = part + ": " + name(status) + (reason.empty() ? "" : ", " + reason);
    return status;
}

Status Simulation::fail_in_step(Status status) {
    return fail(status, "step of " + setup_.method, system_->reason(status));
}

Status Simulation::fail_after(Status status) {
    if (passage_ && !passage_->reason().empty())
        return fail(status, "state after a step of " + setup_.method, passage_->reason());
    return fail(status, "projection " + setup_.projection, system_->reason(status));
}

Status Simulation::fail_in_stride(Status status) {
    const bool passing = passage_ && !passage_->reason().empty();
    return fail(status, stepper_->failed_part(), passing ? passage_->reason() : system_->reason(status));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
