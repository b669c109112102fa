// SPDX-License-Identifier: BSD-3-Clause
//
// Every kind of motion of a free body, and how far two solutions may differ.
#pragma once

#include <string>
#include <vector>

#include "lie/so3.hpp"
#include "mechanics/free_body/free_rotation.hpp"
#include "mechanics/model/data.hpp"

namespace reference_tests {

using namespace kreisel;

/// Inertia and initial angular velocity; the binary values are used, in every precision.
struct FreeBody {
    std::string name;
    Matrix3 inertia;
    Vector3 omega;
    bool fixed_axis = false;
};

const std::vector<FreeBody>& free_bodies();

inline Mat3 to_matrix(const Matrix3& a) {
    Mat3 m;
    m << a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8];
    return m;
}
inline Vec3 to_vector(const Vector3& a) { return {Real(a[0]), Real(a[1]), Real(a[2])}; }

/// The larger one of the angle between the rotations (rad) and the distance of the angular velocities (rad/s).
inline Real distance(const FreeRotation& a, const FreeRotation& b) {
    const Real angle = SO3::log(a.R.transpose() * b.R).norm(), rate = (a.omega - b.omega).norm();
    return max(angle, rate);
}

/// How much relative changes of the inertia and of omega(0) are magnified at time t, at least 1: a result that is
/// right to the last digit for data changed in their last digit may be wrong by this factor times epsilon.
Real condition(const FreeBody& body, const Mat3& R0, const Real& t);

}  // namespace reference_tests
