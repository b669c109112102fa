// SPDX-License-Identifier: BSD-3-Clause
//
// Runs of a method on a problem of the registry, without the driver.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/report/report.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/projection.hpp"
#include "tests/mechanics/models/models.hpp"

namespace stepping {

using namespace kreisel;

inline OptionValues default_options(const std::vector<OptionDescription>& options) {
    return with_defaults({}, options);
}

/// In steps of a given size.
inline bool runs_on(const MethodDescription& method, const std::string& formulation) {
    const auto& only = method.formulations;
    return !method.own_control && (only.empty() || std::find(only.begin(), only.end(), formulation) != only.end());
}

/// The same, and the method does not decline the system.
inline bool runs_on(const Method& method, const Model& model, const std::string& formulation) {
    if (!runs_on(method.description, formulation)) return false;
    return !method.factory.declines || method.factory.declines(*make_system(model, formulation)).empty();
}

/// Whether a projection goes with a method: one that meets the constraints has none.
inline bool go_together(const MethodDescription& method, const ProjectionMethod& projection) {
    const bool nothing = !projection.description.positions && !projection.description.velocities;
    if (!projection.stabilises() && nothing) return true;
    return !method.meets_constraints() && projection.why_not(method).empty();
}

inline bool runs_on(const ProjectionDescription& projection, const Model& model, const std::string& formulation) {
    const auto& only = projection.formulations;
    if (!only.empty() && std::find(only.begin(), only.end(), formulation) == only.end()) return false;
    return !projection.ambient || make_system(model, formulation)->has_ambient_jacobian();
}

/// The literature's top rotates at 150 rad/s, the other models at about 5: it needs shorter steps.
inline bool spins_fast(const Model& model) {
    return std::any_of(model.bodies.begin(), model.bodies.end(),
                       [](const Body& body) { return body.start.omega.norm() > 50; });
}

/// A method, a projection and a system, stepping. Its parts are open, where those of a Simulation are not: tests repeat
/// steps, spoil states between them, exchange the projection, and look at states that a SingularPassage would refuse.
struct Trip {
    Trip(const Model& m, const std::string& formulation, const Method& method, const OptionValues& options,
         const std::string& projector = "none", const OptionValues& projection_options = {})
        : model(m), system(make_system(model, formulation)), y(initial_state(*system, model)) {
        const ProjectionMethod& entry = projection(projector);
        project = entry.make(*system, with_defaults(projection_options, entry.description.options));
        changed = entry.changed(*system, projection_options);
        integrator = method.bind(changed ? *changed : *system, options);
    }
    Trip(const Model& m, const std::string& formulation, const Method& method, const std::string& projector = "none")
        : Trip(m, formulation, method, default_options(method.description.options), projector) {}

    /// N steps to t_end; the first status that is not ok, or ok.
    Status run(const Real& t_end, long steps) {
        const Real h = t_end / Real(steps);
        project->start();
        Status status = integrator->start(0, y.data());
        for (long i = 0; i < steps && status == Status::ok; ++i) {
            status = integrator->step(h * Real(i), h, y.data());
            if (status == Status::ok) status = project->project(h * Real(i + 1), y.data());
        }
        return status;
    }

    std::vector<BodyState> bodies() const {
        std::vector<BodyState> states(model.bodies.size());
        system->read(y.data(), states.data());
        return states;
    }
    Real position_defect(const Real& t = 0) const {
        VecX rows(system->position_constraints());
        system->position_residual(t, y.data(), rows.data());
        return rows.norm();
    }
    Real velocity_defect(const Real& t = 0) const {
        VecX rows(system->constraints());
        system->velocity_residual(t, y.data(), system->v(y.data()), rows.data());
        return rows.norm();
    }

    Model model;
    std::unique_ptr<System> system, changed;  // what the integrator sees under a stabilisation
    std::vector<Real> y;
    std::unique_ptr<Integrator> integrator;
    std::unique_ptr<Projection> project;
};

/// Largest of the four distances.
inline Real worst(const Distance& d) { return max(max(d.position, d.rotation), max(d.velocity, d.omega)); }

}  // namespace stepping
