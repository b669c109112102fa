// SPDX-License-Identifier: BSD-3-Clause
//
// What the forces of a model exert on its bodies, gravity apart: the equations are those of mechanics/model/model.hpp.
#pragma once

#include "mechanics/model/model.hpp"
#include "mechanics/model/motion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// On the two bodies of a force element, each in its own body axes.
struct WrenchPair {
    Wrench first, second;
};

/// The angle of a torsion spring, from two poses and velocities.
struct Turn {
    Real principal;  ///< theta up to full turns, in (-pi, pi]
    Vec3 gradient;   ///< theta' = gradient . (omega_second - omega_first) in space axes
    Real rate;       ///< theta'
    Real shadow;     ///< length of the second frame's first axis, projected on the plane of the first: 1 on one axis
};
Turn turn(const TorsionSpring& spring, const Motion& first, const Motion& second);

WrenchPair exerted(const Spring& spring, const Motion& first, const Motion& second);
/// At the angle theta, all turns counted.
WrenchPair exerted(const TorsionSpring& spring, const Turn& turn, const Real& theta, const Motion& first,
                   const Motion& second);

/// Stored energy (J): stiffness/2 (l - length)^2, stiffness/2 (theta - angle)^2.
Real stored_energy(const Spring& spring, const Motion& first, const Motion& second);
Real stored_energy(const TorsionSpring& spring, const Real& theta);

/// Calls push(body, wrench) for every load and every end of a spring on a moving body; motion(body) is the Motion of a
/// body or of the ground, angle(i, turn) the angle of torsion spring i.
template <class MotionOf, class AngleOf, class Push>
void for_each_wrench(const Model& model, const Real& t, MotionOf motion, AngleOf angle, Push push) {
    for (const Load& load : model.loads) push(load.body, load.in_body_axes(t, motion(load.body).R));
    const auto push_pair = [&](const auto& element, const WrenchPair& pair) {
        if (element.first != ground) push(element.first, pair.first);
        if (element.second != ground) push(element.second, pair.second);
    };
    for (const Spring& spring : model.springs)
        push_pair(spring, exerted(spring, motion(spring.first), motion(spring.second)));
    for (std::size_t i = 0; i < model.torsion_springs.size(); ++i) {
        const TorsionSpring& spring = model.torsion_springs[i];
        const Motion first = motion(spring.first), second = motion(spring.second);
        const Turn now = turn(spring, first, second);
        push_pair(spring, exerted(spring, now, angle(i, now), first, second));
    }
}

/// Whether anything but gravity acts.
inline bool has_forces(const Model& model) {
    return !model.loads.empty() || !model.springs.empty() || !model.torsion_springs.empty();
}

/// Whether all forces, gravity included, follow from a potential that does not depend on time.
bool is_conservative(const Model& model);

/// Energy stored in the springs; theta(i) is the angle of torsion spring i.
template <class MotionOf, class AngleOf>
Real stored_energy(const Model& model, MotionOf motion, AngleOf theta) {
    Real sum = 0;
    for (const Spring& spring : model.springs)
        sum += stored_energy(spring, motion(spring.first), motion(spring.second));
    for (std::size_t i = 0; i < model.torsion_springs.size(); ++i)
        sum += stored_energy(model.torsion_springs[i], theta(i));
    return sum;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
