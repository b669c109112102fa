// SPDX-License-Identifier: BSD-3-Clause
//
// What the forces of a model exert between two bodies, or a body and the ground, as reported: springs, dampers,
// bushings and attractions, by their own laws. Loads are left out.
#pragma once

#include <string>
#include <vector>

#include "engine/engine.hpp"
#include "mechanics/model/model.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Calls f(force, i) for every force that acts between two bodies; i counts within its list.
template <class F>
void each_force_between(const Forces& forces, F f) {
    forces.each([&](const auto& force, std::size_t i) {
        if constexpr (requires { force.first; }) f(force, i);
    });
}

/// The names in results, all different, in the order of each_force_between: "spring.crank-rod", and
/// "spring.crank-rod-2" of a second one between the same bodies.
std::vector<std::string> names_of_forces(const Model& model);

/// Of each force the wrench on its second body in space axes, the first gets the opposite: a force (N) at the force's
/// point of the second body, if it has a force, and a torque about it (N m), if there is one. One without a point has a
/// torque only.
class ExertedForces {
  public:
    /// Refers to the model.
    explicit ExertedForces(const Model& model) : model_(model) {}
    /// "exerted.NAME.force.1", ..., "exerted.NAME.torque.3".
    std::vector<Column> columns() const;
    void append_values(const Real& t, const MotionState& now, std::vector<Real>& row) const;

  private:
    const Model& model_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
