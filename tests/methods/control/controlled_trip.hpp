// SPDX-License-Identifier: BSD-3-Clause
//
// Runs of a method, which need not be registered, to a tolerance.
#pragma once

#include <functional>

#include "methods/control/stepper.hpp"
#include "tests/methods/stepping.hpp"

namespace stepping {

/// A stepper of a method on a model with all it needs, and the states it has been through.
class ControlledTrip {
  public:
    using Bind = std::function<std::unique_ptr<Stepper>(const Method&, System&, Projection&, const Accuracy&)>;

    ControlledTrip(const Model& model, const std::string& formulation, const Method& entry, const Accuracy& accuracy,
                   const std::string& projector = "none", const Bind& bind = standard, const OptionValues& how = {})
        : system(make_system(model, formulation)),
          changed(projection(projector).changed(*system, how)),
          project(projection(projector).make(*system, how)),
          stepper(bind(entry, changed ? *changed : *system, *project, accuracy)),
          y(initial_state(*system, model)) {}

    static std::unique_ptr<Stepper> standard(const Method& entry, System& system, Projection& project,
                                             const Accuracy& accuracy) {
        return bind_stepper(entry, system, project, accuracy, default_options(entry.description.options));
    }

    Status run(const Real& t_end) {
        times = {0}, states = {y};
        Real t = 0;
        Status status = stepper->start(t, t_end, y.data());
        while (status == Status::ok && t < t_end) {
            status = stepper->step(t, t_end, y.data());
            times.push_back(t), states.push_back(y);
        }
        return status;
    }

    std::unique_ptr<System> system, changed;  // what the stepper sees under a stabilisation
    std::unique_ptr<Projection> project;
    std::unique_ptr<Stepper> stepper;
    std::vector<Real> y, times;
    std::vector<std::vector<Real>> states;
};

}  // namespace stepping
