// SPDX-License-Identifier: BSD-3-Clause
//
// The result of a run, independent of formulation and order of rows, so that it can be mapped from a
// transformed model back to the original.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mechanics/model/motion.hpp"
#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

struct Combination {
    std::string method, formulation, projection;
    OptionValues options = {}, projection_options = {};  ///< other than the defaults
};

using kreisel::to_text;  // of numbers
/// "rkmk/rk4, SE3, position_velocity".
std::string to_text(const Combination& combination);

/// Force in space axes and torque about the mass centre in space axes.
struct Action {
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    void add(const Action& other) { force += other.force, torque += other.torque; }
};

/// The largest sizes of x, v, omega and of the forces and torques of single joints along a run.
struct Sizes {
    Real x = 0, v = 0, omega = 0, force = 0, torque = 0;
};

struct Outcome {
    std::string failure;  ///< empty: every step was ok
    std::vector<BodyState> bodies;
    std::vector<std::array<Action, 2>>
        joints;  ///< of each joint on its first and its second body, from C^T lambda; none on the ground
    std::vector<Action> totals;  ///< of all joints on each body
    std::map<std::string, Real> integrals;
    Sizes sizes;
};

/// Makes system, method and projection: those of the registries, or doubles with a fault.
struct Bench {
    std::function<std::unique_ptr<System>(const Model&, const std::string&)> system;
    std::function<std::unique_ptr<Integrator>(System&, const Combination&)> integrator;
    std::function<std::unique_ptr<Projection>(System&, const Combination&)> projection;
    Bench();
};

/// A run of N steps of h; `restart` makes the method drop its memory in the middle.
struct Span {
    Real h;
    int steps;
    bool restart = false;
};

Outcome run(const Model& model, const Combination& combination, const Span& span, const Bench& bench = {});

/// Largest rate of the model at its start (1/s): rotation, accelerations over the extent, springs, loads.
Real fastest_rate(const Model& model);

/// The motion of a body in space, as joints see it; the ground for `ground`.
Motion motion_of(const std::vector<BodyState>& bodies, int body);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
