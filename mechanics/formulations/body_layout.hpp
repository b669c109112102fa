// SPDX-License-Identifier: BSD-3-Clause
//
// Where a body lies in the flat state of a formulation, which its `Coordinates` define:
//
//   Factor      the group of one body, a Kernel (lie/power.hpp) whose element is x and then the rotation
//   Rotations   how the rotation is stored: MatrixStorage, QuaternionStorage
//   velocity maps between v = (v_1, omega) and what the equations of motion are solved in
//               (mechanics/formulations/velocity_maps.hpp)
#pragma once

#include "lie/s3.hpp"
#include "mechanics/model/data.hpp"
#include "mechanics/model/model.hpp"
#include "mechanics/model/motion.hpp"

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

/// The parts of q and v that belong to a body.
template <class Coordinates>
struct BodyLayout {
    static constexpr int pose_size = Coordinates::Factor::size;

    static const Real* pose(const Real* q, int body) { return q + body * pose_size; }
    static auto rotation(const Real* q, int body) { return Coordinates::Rotations::rotation(pose(q, body) + 3); }
    static Vec3 position(const Real* q, int body) { return vec3(pose(q, body)); }
    static Vec3 linear(const Real* v, int body) { return vec3(v + body * 6); }  ///< v_1
    static Vec3 angular(const Real* v, int body) { return vec3(v + body * 6 + 3); }

    /// Of a body or of the ground; without v, at rest.
    static Motion motion(const Real* q, const Real* v, int body) {
        if (body == ground) return {};
        const auto R = rotation(q, body);
        Motion motion{position(q, body), R};
        if (v) motion.V = R.transpose() * Coordinates::to_space(R, linear(v, body)), motion.omega = angular(v, body);
        return motion;
    }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
