// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies of simple shapes, and rigidly moving starts, shared by the mechanisms.
#pragma once

#include "problems/problem.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Inertia of a box of sides a, b, c along the body axes, about its centre.
inline Mat3 box_inertia(const Real& mass, const Real& a, const Real& b, const Real& c) {
    return Vec3(mass / 12 * (b * b + c * c), mass / 12 * (a * a + c * c), mass / 12 * (a * a + b * b)).asDiagonal();
}

/// Principal moments about the body axes, as decimals.
inline Mat3 moments(double a, double b, double c) { return Vec3(decimal(a), decimal(b), decimal(c)).asDiagonal(); }

/// Rotation whose third column is along z, the first along x; both of length 1 and perpendicular to each other.
inline Mat3 axes_along(const Vec3& x, const Vec3& z) {
    Mat3 R;
    R << x, z.cross(x), z;
    return R;
}

/// The state of a body in a system that rotates rigidly with angular velocity w (space axes) about the point P.
inline BodyState turning(const Vec3& x, const Mat3& R, const Vec3& P, const Vec3& w) {
    return {x, R, w.cross(x - P), R.transpose() * w};
}

inline ParameterDescription gravity_parameter(const Vector3& standard) {
    return {"gravity", ParameterKind::vector, "m/s^2", "gravity, space axes", standard};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
