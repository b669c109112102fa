// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forces/spring.hpp"

#include "mechanics/forces/entry.hpp"
#include "mechanics/forces/forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

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

Real stored_energy(const Spring& spring, const Motion& first, const Motion& second) {
    const Real stretch = (second.point(spring.r_second) - first.point(spring.r_first)).norm() - spring.length;
    return spring.stiffness / 2 * stretch * stretch;
}

namespace {

void read_spring(const ForceEntry& entry, Forces& forces) {
    const Spring spring{.first = entry.first,
                        .second = entry.second,
                        .r_first = entry.r_first,
                        .r_second = entry.r_second,
                        .stiffness = entry.stiffness,
                        .damping = entry.damping,
                        .length = entry.rest.value_or(entry.distance)};
    if (entry.distance == 0 && (spring.length != 0 || spring.damping != 0))
        entry.refuse("points",
                     "expected two different points, since the force of a spring with a free length or damping acts "
                     "along their line");
    forces.springs.push_back(spring);
}

}  // namespace

KREISEL_FORCE(Spring::type, read_spring);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
