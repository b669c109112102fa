// SPDX-License-Identifier: BSD-3-Clause
//
// A force and a torque on a body, and on both bodies between which a force acts.
#pragma once

#include "mechanics/model/motion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A force and a torque about the mass centre, in body axes.
struct Wrench {
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
};

/// On the two bodies of a force, each in its own body axes.
struct WrenchPair {
    Wrench first, second;
};

/// Of a force in space axes that acts at the point r of a body (body axes, from the mass centre).
inline Wrench force_at(const Motion& body, const Vec3& force, const Vec3& r) {
    const Vec3 mine = body.R.transpose() * force;
    return {mine, r.cross(mine)};
}

/// Of a force in space axes that acts at a point in space.
inline Wrench force_through(const Motion& body, const Vec3& force, const Vec3& point) {
    return force_at(body, force, body.R.transpose() * (point - body.x));
}

/// Calls push(body, wrench) for each of the two bodies of a force that moves.
template <class Force, class Push>
void push_pair(const Force& force, const WrenchPair& pair, Push&& push) {
    if (force.first != ground) push(force.first, pair.first);
    if (force.second != ground) push(force.second, pair.second);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
