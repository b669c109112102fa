// SPDX-License-Identifier: BSD-3-Clause
//
// What the forces of a model exert on its bodies, gravity apart: the equations are those of mechanics/model.hpp.
#pragma once

#include "mechanics/model.hpp"
#include "mechanics/motion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// On the two bodies of a force element, each in its own body axes.
struct WrenchPair {
    Wrench first, second;
};

WrenchPair exerted(const Spring& spring, const Motion& first, const Motion& second);
WrenchPair exerted(const TorsionSpring& spring, const Motion& first, const Motion& second);

/// Stored energy (J): stiffness/2 (l - length)^2, stiffness/2 (theta - angle)^2.
Real stored_energy(const Spring& spring, const Motion& first, const Motion& second);
Real stored_energy(const TorsionSpring& spring, const Motion& first, const Motion& second);

/// Calls push(body, wrench) for every load and every end of a spring on a moving body; motion(body) is the Motion of a
/// body or of the ground.
template <class MotionOf, class Push>
void for_each_wrench(const Model& model, const Real& t, MotionOf motion, Push push) {
    for (const Load& load : model.loads) push(load.body, load.in_body_axes(t, motion(load.body).R));
    const auto push_pair = [&](const auto& element) {
        const WrenchPair pair = exerted(element, motion(element.first), motion(element.second));
        if (element.first != ground) push(element.first, pair.first);
        if (element.second != ground) push(element.second, pair.second);
    };
    for (const Spring& spring : model.springs) push_pair(spring);
    for (const TorsionSpring& spring : model.torsion_springs) push_pair(spring);
}

/// Whether anything but gravity acts.
inline bool has_forces(const Model& model) {
    return !model.loads.empty() || !model.springs.empty() || !model.torsion_springs.empty();
}

/// Whether all forces, gravity among them, follow from a potential that does not depend on time.
bool is_conservative(const Model& model);

/// Energy stored in the springs.
template <class MotionOf>
Real stored_energy(const Model& model, MotionOf motion) {
    Real sum = 0;
    for (const Spring& spring : model.springs) sum += stored_energy(spring, motion(spring.first), motion(spring.second));
    for (const TorsionSpring& spring : model.torsion_springs)
        sum += stored_energy(spring, motion(spring.first), motion(spring.second));
    return sum;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
