// SPDX-License-Identifier: BSD-3-Clause
//
// The free rigid body in closed form: Jacobi elliptic functions for the angular velocity, an elliptic integral of the
// third kind for the rotation [celledonifasso2008].
#pragma once

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct FreeRotation {
    Mat3 R;      ///< body to space
    Vec3 omega;  ///< body axes, rad/s
};

/// Moments I(0) <= I(1) <= I(2), and the right-handed principal axes as columns, in body axes.
struct PrincipalAxes {
    Vec3 I;
    Mat3 Q;
};
/// Of a symmetric J; a diagonal one is only sorted, so that exact relations between its moments stay exact.
PrincipalAxes principal_axes(const Mat3& J);

/// The exact flow of a free body with inertia J (symmetric, positive definite, body axes), whose principal axes are
/// computed once. Allocates nothing.
class FreeRotor {
  public:
    explicit FreeRotor(const Mat3& J) : axes_(principal_axes(J)) {}
    /// Rotation and angular velocity after the time t; NaN where data are not finite.
    FreeRotation after(const Mat3& R0, const Vec3& omega0, const Real& t) const;

  private:
    PrincipalAxes axes_;
};

/// The same for a body that is used once.
inline FreeRotation free_rotation(const Mat3& J, const Mat3& R0, const Vec3& omega0, const Real& t) {
    return FreeRotor(J).after(R0, omega0, t);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
