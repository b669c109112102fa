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

/// Rotation and angular velocity at time t of a free body with inertia J (symmetric, positive definite, body axes).
FreeRotation free_rotation(const Mat3& J, const Mat3& R0, const Vec3& omega0, const Real& t);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
