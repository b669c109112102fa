// SPDX-License-Identifier: BSD-3-Clause
//
// The formulations of free bodies: where a pose lies in the flat state, and how its velocity coordinates relate to
// the body-axis acceleration A = R^T x'' in which the equations of motion are solved.
#pragma once

#include "lie/pair.hpp"
#include "lie/rn.hpp"
#include "lie/s3.hpp"
#include "lie/se3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A rotation where it lies in the state, as a matrix and as a quaternion.
struct MatrixStorage {
    static Eigen::Map<const Mat3> rotation(const Real* p) { return mat3(p); }
    static void save(const Mat3& R, Real* p) { store(R, p); }
};
struct QuaternionStorage {
    static Mat3 rotation(const Real* p) { return S3::rotation(S3::load(p)); }
    static void save(const Mat3& R, Real* p) { S3::save(S3::of_rotation(R), p); }
};

/// R^3 and rotations per body: q = (x, R), v = (x', omega). Translation in space axes, rotation in body axes.
template <class RotationGroup, class Storage>
struct SplitCoordinates {
    using Factor = Pair<Rn<3>, RotationGroup>;
    using Rotations = Storage;
    /// x' in space axes.
    static Vec3 space_velocity(const auto&, const Vec3& linear) { return linear; }
    static Vec3 from_space_velocity(const auto&, const Vec3& velocity) { return velocity; }
    /// Body-axis vector to the linear part of a velocity or of M^{-1} force, and back.
    static Vec3 from_body(const auto& R, const Vec3& a) { return R * a; }
    static Vec3 to_body(const auto& R, const Vec3& a) { return R.transpose() * a; }
    static Vec3 from_space(const auto&, const Vec3& a) { return a; }
    static Vec3 to_space(const auto&, const Vec3& a) { return a; }
    /// Linear part of v' from A, and from x''.
    static Vec3 acceleration(const auto& R, const Vec3& A, const Vec3&, const Vec3&) { return R * A; }
    static Vec3 from_space_acceleration(const auto&, const Vec3& a, const Vec3&, const Vec3&) { return a; }
    /// d(linear velocity)/dt - its body-axis image is A: the centripetal part of the body frame, none here.
    static Vec3 gyroscopic(const Real&, const Vec3&, const Vec3&) { return Vec3::Zero(); }
};
using SO3xR3Coordinates = SplitCoordinates<SO3, MatrixStorage>;
using S3xR3Coordinates = SplitCoordinates<S3, QuaternionStorage>;

/// SE(3) per body: q = (x, R), v = (V, omega) with V = R^T x'.
struct SE3Coordinates {
    using Factor = SE3;
    using Rotations = MatrixStorage;
    static Vec3 space_velocity(const auto& R, const Vec3& linear) { return R * linear; }
    static Vec3 from_space_velocity(const auto& R, const Vec3& velocity) { return R.transpose() * velocity; }
    static Vec3 from_body(const auto&, const Vec3& a) { return a; }
    static Vec3 to_body(const auto&, const Vec3& a) { return a; }
    static Vec3 from_space(const auto& R, const Vec3& a) { return R.transpose() * a; }
    static Vec3 to_space(const auto& R, const Vec3& a) { return R * a; }
    /// V' = R^T x'' - omega x V.
    static Vec3 acceleration(const auto&, const Vec3& A, const Vec3& omega, const Vec3& V) {
        return A - omega.cross(V);
    }
    static Vec3 from_space_acceleration(const auto& R, const Vec3& a, const Vec3& omega, const Vec3& V) {
        return R.transpose() * a - omega.cross(V);
    }
    /// -m omega x V.
    static Vec3 gyroscopic(const Real& mass, const Vec3& omega, const Vec3& V) { return -mass * omega.cross(V); }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
