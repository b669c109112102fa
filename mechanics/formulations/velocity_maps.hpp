// SPDX-License-Identifier: BSD-3-Clause
//
// What v_1, the translational velocity coordinates of a body, can be. The equations of motion are solved in space axes
// or in body axes (R maps body to space); six maps lead there and back, and are all that they need to know of v_1:
//
//   to_space(R, v_1)            x'; likewise any vector in the axes of v_1, M^{-1} f among them, turned into space axes
//   from_space(R, x')           v_1
//   to_body(R, v_1)             V = R^T x'
//   from_body(R, V)             v_1
//   rate(a, omega, v_1)         v_1' from a, which is x'' in the axes of v_1
//   gyroscopic(m, omega, v_1)   m (v_1' - a): the translational part of the gyroscopic force
#pragma once

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// v_1 = x', in space axes: they do not turn.
struct SpaceVelocity {
    static Vec3 to_space(const auto&, const Vec3& a) { return a; }
    static Vec3 from_space(const auto&, const Vec3& a) { return a; }
    static Vec3 to_body(const auto& R, const Vec3& a) { return R.transpose() * a; }
    static Vec3 from_body(const auto& R, const Vec3& a) { return R * a; }
    static Vec3 rate(const Vec3& a, const Vec3&, const Vec3&) { return a; }
    static Vec3 gyroscopic(const Real&, const Vec3&, const Vec3&) { return Vec3::Zero(); }
};

/// v_1 = R^T x', in body axes, which turn by omega: v_1' = R^T x'' - omega x v_1.
struct BodyVelocity {
    static Vec3 to_space(const auto& R, const Vec3& a) { return R * a; }
    static Vec3 from_space(const auto& R, const Vec3& a) { return R.transpose() * a; }
    static Vec3 to_body(const auto&, const Vec3& a) { return a; }
    static Vec3 from_body(const auto&, const Vec3& a) { return a; }
    static Vec3 rate(const Vec3& a, const Vec3& omega, const Vec3& v) { return a - omega.cross(v); }
    static Vec3 gyroscopic(const Real& m, const Vec3& omega, const Vec3& v) { return -m * omega.cross(v); }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
