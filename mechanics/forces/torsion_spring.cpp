// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forces/torsion_spring.hpp"

#include "mechanics/forces/entry.hpp"
#include "mechanics/forces/forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// This is the gradient if the frames share their third axis.
Turn turn(const TorsionSpring& spring, const Motion& first, const Motion& second) {
    const Vec3 u = second.direction(spring.axes_second.col(0));
    const Vec3 f1 = first.direction(spring.axes_first.col(0)), f2 = first.direction(spring.axes_first.col(1));
    const Real x = u.dot(f1), y = u.dot(f2), square = x * x + y * y;
    const Vec3 gradient = u.cross(x * f2 - y * f1) / square;
    return {atan2(y, x), gradient, gradient.dot(second.R * second.omega - first.R * first.omega), sqrt(square)};
}

WrenchPair exerted(const TorsionSpring& spring, const Turn& turn, const Real& theta, const Motion& first,
                   const Motion& second) {
    const Vec3 torque = (-spring.stiffness * (theta - spring.angle) - spring.damping * turn.rate) * turn.gradient;
    return {{Vec3::Zero(), first.R.transpose() * -torque}, {Vec3::Zero(), second.R.transpose() * torque}};
}

Real stored_energy(const TorsionSpring& spring, const Real& theta) {
    return spring.stiffness / 2 * (theta - spring.angle) * (theta - spring.angle);
}

namespace {

void read_torsion_spring(const ForceEntry& entry, Forces& forces) {
    forces.torsion_springs.push_back({.first = entry.first,
                                      .second = entry.second,
                                      .axes_first = entry.axes_first,
                                      .axes_second = entry.axes_second,
                                      .stiffness = entry.stiffness,
                                      .damping = entry.damping,
                                      .angle = entry.rest.value_or(0),
                                      .turns = entry.turns});
}

}  // namespace

KREISEL_FORCE(TorsionSpring::type, read_torsion_spring);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
