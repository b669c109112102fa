// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forces/forces.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Wrench force_at(const Motion& body, const Vec3& force, const Vec3& r) {
    const Vec3 mine = body.R.transpose() * force;
    return {mine, r.cross(mine)};
}

}  // namespace

/// This is the gradient if the frames share their third axis.
Turn turn(const TorsionSpring& spring, const Motion& first, const Motion& second) {
    const Vec3 u = second.direction(spring.axes_second.col(0));
    const Vec3 f1 = first.direction(spring.axes_first.col(0)), f2 = first.direction(spring.axes_first.col(1));
    const Real x = u.dot(f1), y = u.dot(f2), square = x * x + y * y;
    const Vec3 gradient = u.cross(x * f2 - y * f1) / square;
    return {atan2(y, x), gradient, gradient.dot(second.R * second.omega - first.R * first.omega), sqrt(square)};
}

WrenchPair exerted(const Spring& spring, const Motion& first, const Motion& second) {
    const Vec3 d = second.point(spring.r_second) - first.point(spring.r_first);
    Vec3 tension = spring.stiffness * d;  // on the first body, towards the second
    if (spring.length != 0 || spring.damping != 0) {
        const Real l = d.norm();
        const Vec3 rate = second.point_velocity(spring.r_second) - first.point_velocity(spring.r_first);
        tension += (spring.damping * d.dot(rate) / l - spring.stiffness * spring.length) / l * d;
    }
    return {force_at(first, tension, spring.r_first), force_at(second, -tension, spring.r_second)};
}

WrenchPair exerted(const TorsionSpring& spring, const Turn& turn, const Real& theta, const Motion& first,
                   const Motion& second) {
    const Vec3 torque = (-spring.stiffness * (theta - spring.angle) - spring.damping * turn.rate) * turn.gradient;
    return {{Vec3::Zero(), first.R.transpose() * -torque}, {Vec3::Zero(), second.R.transpose() * torque}};
}

Real stored_energy(const Spring& spring, const Motion& first, const Motion& second) {
    const Real stretch = (second.point(spring.r_second) - first.point(spring.r_first)).norm() - spring.length;
    return spring.stiffness / 2 * stretch * stretch;
}

Real stored_energy(const TorsionSpring& spring, const Real& theta) {
    return spring.stiffness / 2 * (theta - spring.angle) * (theta - spring.angle);
}

bool is_conservative(const Model& model) {
    const auto undamped = [](const auto& spring) { return spring.damping == 0; };
    return model.gravity.is_constant() && model.loads.empty() &&
           std::all_of(model.springs.begin(), model.springs.end(), undamped) &&
           std::all_of(model.torsion_springs.begin(), model.torsion_springs.end(), undamped);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
