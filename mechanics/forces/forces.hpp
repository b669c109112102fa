// SPDX-License-Identifier: BSD-3-Clause
//
// The forces of a model, gravity apart, and what all of them do together. A force is a struct of plain data with its
// law, and one that holds a list of them, in a file of this folder. With motion(body), the Motion of a body or of the
// ground, and with an angle where it counts full turns (mechanics/turns.hpp), a force has
//
//   type                          what results call it, of one between two bodies, or a body and the ground
//   act(t, motion, angle, push)   calls push(body, wrench) for every moving body it acts on; angle(turn) is theta
//   damp(motion, push)            the same for the part of it that depends on velocities: it takes energy out, and the
//                                 rest is what acts where all bodies are at rest
//   is_damped()                   it has such a part
//   energy(motion, angle)         stored energy (J), 0 if there is none; angle() is theta
//   is_conservative()             it follows from a potential that does not depend on time
//   is_internal()                 it acts between moving bodies only, and keeps the linear and angular momentum of
//                                 the system
//   touches(body)                 it acts on this body, or on the ground
//   may_push(body)                it can exert a force on a body that it touches, and not only a torque
//   centre_on(body)               of a body that it touches, the point (body axes) through which all it exerts on it
//                                 passes; of the ground, the point about which it has no moment; null if there is none
//
// tests/mechanics/force_types.cpp holds every force to this, tests/engine/jointed_routes.cpp to its series.
#pragma once

#include "mechanics/forces/attraction.hpp"
#include "mechanics/forces/bushing.hpp"
#include "mechanics/forces/damper.hpp"
#include "mechanics/forces/force_lists.hpp"
#include "mechanics/forces/load.hpp"
#include "mechanics/forces/polynomial_spring.hpp"
#include "mechanics/forces/rotational_damper.hpp"
#include "mechanics/forces/spring.hpp"
#include "mechanics/forces/torsion_spring.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// All of them; they act in this order.
struct Forces
    : ForceLists<Loads, Springs, TorsionSprings, PolynomialSprings, Dampers, RotationalDampers, Bushings, Attractions> {
};

/// Calls push(body, wrench) for everything that a force exerts on a moving body; angle(i, turn) is the angle of the
/// i-th force of a list, of those that count turns.
template <class MotionOf, class AngleOf, class Push>
void for_each_wrench(const Forces& forces, const Real& t, MotionOf motion, AngleOf angle, Push push) {
    forces.each([&](const auto& force, std::size_t i) {
        force.act(
            t, motion, [&](const auto& turn) { return angle(i, turn); }, push);
    });
}

/// Calls push(body, wrench) for what dampers exert.
template <class MotionOf, class Push>
void for_each_damping(const Forces& forces, MotionOf motion, Push push) {
    forces.each([&](const auto& force, std::size_t) { force.damp(motion, push); });
}

/// Energy stored in all forces (J); theta(i) is the angle of torsion spring i.
template <class MotionOf, class AngleOf>
Real stored_energy(const Forces& forces, MotionOf motion, AngleOf theta) {
    Real sum = 0;
    forces.each([&](const auto& force, std::size_t i) { sum += force.energy(motion, [&] { return theta(i); }); });
    return sum;
}

inline bool has_dampers(const Forces& forces) {
    return forces.any([](const auto& force) { return force.is_damped(); });
}

/// Whether anything but gravity acts.
inline bool has_forces(const Forces& forces) {
    return forces.any([](const auto&) { return true; });
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
