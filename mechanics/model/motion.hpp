// SPDX-License-Identifier: BSD-3-Clause
//
// Pose and velocity of a body as joints and forces use it, the same in every formulation.
#pragma once

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// In place of the number of a body.
inline constexpr int ground = -1;

/// x in space axes, R body to space, V = R^T x' and omega in body axes. The default is the ground.
struct Motion {
    Vec3 x = Vec3::Zero();
    Mat3 R = Mat3::Identity();
    Vec3 V = Vec3::Zero(), omega = Vec3::Zero();

    /// Of a point r fixed in the body (body axes), in space axes.
    Vec3 point(const Vec3& r) const { return x + R * r; }
    Vec3 point_velocity(const Vec3& r) const { return R * (V + omega.cross(r)); }
    /// Of a direction b fixed in the body (body axes), in space axes: R b, its rate, and its second rate where
    /// omega' = 0.
    Vec3 direction(const Vec3& b) const { return R * b; }
    Vec3 direction_rate(const Vec3& b) const { return R * omega.cross(b); }
    Vec3 direction_bias(const Vec3& b) const { return R * omega.cross(omega.cross(b)); }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
