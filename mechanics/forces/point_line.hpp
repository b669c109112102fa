// SPDX-License-Identifier: BSD-3-Clause
//
// The line between two points of bodies, along which some forces act.
#pragma once

#include "mechanics/forces/wrench.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// From the first point to the second.
struct PointLine {
    Vec3 direction;     ///< unit vector in space axes; the points may not meet
    Real length, rate;  ///< l (m) and l' (m/s)
};

/// Of a force between the points r_first and r_second (body axes) of its bodies.
template <class Force>
PointLine point_line(const Force& force, const Motion& first, const Motion& second) {
    const Vec3 d = second.point(force.r_second) - first.point(force.r_first);
    const Real l = d.norm();
    const Vec3 direction = d / l;
    return {direction, l, direction.dot(second.point_velocity(force.r_second) - first.point_velocity(force.r_first))};
}

/// What a tension (N) along the line exerts: positive, it pulls the points together.
template <class Force>
WrenchPair pulled(const Force& force, const Motion& first, const Motion& second, const PointLine& line,
                  const Real& tension) {
    const Vec3 pull = tension * line.direction;
    return {force_at(first, pull, force.r_first), force_at(second, -pull, force.r_second)};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
