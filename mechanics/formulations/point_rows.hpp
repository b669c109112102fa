// SPDX-License-Identifier: BSD-3-Clause
//
// The rows of a model whose joints are all spherical, three per joint: the points p = x + R r of the two bodies
// coincide. With p' = x' + R (omega x r),
//   Phi = p_first - p_second,   C v = p'_first - p'_second,   C^T lambda: the forces lambda and -lambda at the points.
// They are those of mechanics/joints/joint_rows.hpp, but hold for any 3x3 matrix R, orthogonal or not.
#pragma once

#include <type_traits>

#include "mechanics/formulations/body_layout.hpp"
#include "mechanics/formulations/velocity_maps.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class PointRows {
    using Layout = BodyLayout<Coordinates>;

  public:
    /// Whether Phi and C v are polynomials in the entries of y = (x, R, x', omega).
    static constexpr bool are_polynomials =
        std::is_base_of_v<SpaceVelocity, Coordinates> && std::is_same_v<typename Coordinates::Rotations, MatrixStorage>;

    /// Phi.
    static void positions(const Model& model, const Real* q, Real* phi) {
        const auto point = [&](int body, const Vec3& r) -> Vec3 {
            return body == ground ? r : Vec3(Layout::position(q, body) + Layout::rotation(q, body) * r);
        };
        for (const Joint& joint : model.joints) {
            store(Vec3(point(joint.first, joint.r_first) - point(joint.second, joint.r_second)), phi);
            phi += 3;
        }
    }

    /// Of the points of a joint: the sizes of x and R r of its bodies, whose differences are its rows.
    static Real reach(const Joint& joint, const Real* q) {
        const auto of_point = [&](int body, const Vec3& r) {
            return body == ground ? Real(r.norm()) : Real(Layout::position(q, body).norm() + r.norm());
        };
        return of_point(joint.first, joint.r_first) + of_point(joint.second, joint.r_second);
    }

    /// System::position_scale.
    static void position_scale(const Model& model, const Real* q, Real* size) {
        for (const Joint& joint : model.joints) {
            size[0] = size[1] = size[2] = reach(joint, q);
            size += 3;
        }
    }

    /// C v.
    static void velocities(const Model& model, const Real* q, const Real* v, Real* residual) {
        const auto point_velocity = [&](int body, const Vec3& r) -> Vec3 {
            if (body == ground) return Vec3::Zero();
            const auto R = Layout::rotation(q, body);
            return Coordinates::to_space(R, Layout::linear(v, body)) + R * Layout::angular(v, body).cross(r);
        };
        for (const Joint& joint : model.joints) {
            store(Vec3(point_velocity(joint.first, joint.r_first) - point_velocity(joint.second, joint.r_second)),
                  residual);
            residual += 3;
        }
    }

    /// Calls add(body, force, torque) in body axes for the parts of C^T lambda.
    template <class Add>
    static void transpose(const Model& model, const Real* q, const Real* lambda, Add add) {
        const auto pull = [&](int body, const Vec3& force, const Vec3& r) {
            if (body == ground) return;
            const Vec3 turned = Layout::rotation(q, body).transpose() * force;
            add(body, turned, r.cross(turned));
        };
        for (const Joint& joint : model.joints) {
            pull(joint.first, vec3(lambda), joint.r_first), pull(joint.second, -vec3(lambda), joint.r_second);
            lambda += 3;
        }
    }

    /// d(Phi, C v)/dy where these are polynomials: 2 m rows, the columns those of q (`size` of them) and v. Both are
    /// linear in the columns R_k of R.
    static void ambient_jacobian(const Model& model, const Real* q, const Real* v, Eigen::Index size,
                                 Eigen::Map<MatX>& rows) {
        rows.setZero();
        Eigen::Index row = 0;
        for (const Joint& joint : model.joints) {
            add_ambient_columns(row, joint.first, joint.r_first, 1, q, v, size, rows);
            add_ambient_columns(row, joint.second, joint.r_second, -1, q, v, size, rows);
            row += 3;
        }
    }

  private:
    static void add_ambient_columns(Eigen::Index row, int body, const Vec3& r, int sign, const Real* q, const Real* v,
                                    Eigen::Index size, Eigen::Map<MatX>& rows) {
        if (body == ground) return;
        const Eigen::Index m = rows.rows() / 2, x = body * Layout::pose_size, dx = size + 6 * body;
        const Mat3 identity = sign * Mat3::Identity();
        const Vec3 wr = Layout::angular(v, body).cross(r);
        rows.template block<3, 3>(row, x) = identity;
        rows.template block<3, 3>(m + row, dx) = identity;
        rows.template block<3, 3>(m + row, dx + 3) = -sign * Layout::rotation(q, body) * hat(r);
        for (Eigen::Index k = 0; k < 3; ++k) {
            rows.template block<3, 3>(row, x + 3 + 3 * k) = r[k] * identity;
            rows.template block<3, 3>(m + row, x + 3 + 3 * k) = wr[k] * identity;
        }
    }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
