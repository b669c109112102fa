// SPDX-License-Identifier: BSD-3-Clause
//
// The rows of joints of any kind (mechanics/joints/joint_rows.hpp) in the coordinates of a formulation: joint by joint,
// each placed among the rows of C by RowPlaces.
#pragma once

#include <array>

#include "mechanics/formulations/body_layout.hpp"
#include "mechanics/formulations/point_rows.hpp"
#include "mechanics/formulations/row_places.hpp"
#include "mechanics/joints/joint_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class GeneralRows {
    using Layout = BodyLayout<Coordinates>;

  public:
    /// The model outlives this.
    explicit GeneralRows(const Model& model) : model_(model), places_(model) {}

    const RowPlaces& places() const { return places_; }
    /// Phi.
    void positions(const Real& t, const Real* q, Real* phi) const;
    /// C v + share b.
    void velocities(const Real& t, const Real* q, const Real* v, int share, Real* residual) const;
    void velocity_bias(const Real& t, const Real* q, Real* b) const;
    /// xi.
    void acceleration_bias(const Real& t, const Real* q, const Real* v, Real* xi) const;
    /// C.
    void jacobian(const Real& t, const Real* q, Eigen::Map<MatX>& C) const;
    /// Calls add(body, force, torque) in body axes for the parts of C^T lambda.
    template <class Add>
    void transpose(const Real& t, const Real* q, const Real* lambda, Add add) const;
    /// Of C M^{-1} C^T, with mobility(body, force, torque) = w^T M^{-1} w.
    template <class Mobility>
    void complement_diagonal(const Real& t, const Real* q, Mobility mobility, Real* diagonal) const;
    void reactions(const Real& t, const Real* q, const Real* lambda, JointReaction* out) const;
    /// System::row_scale and System::position_scale.
    void scale(Real* scale) const;
    void position_scale(const Real* q, Real* size) const;

  private:
    int row(std::size_t joint, int k) const { return places_.row(joint, k); }
    /// Calls f(joint, its rows) for all joints.
    template <class F>
    void each_joint(const Real& t, const Real* q, const Real* v, F f) const;

    const Model& model_;
    RowPlaces places_;
};

template <class Coordinates>
template <class F>
void GeneralRows<Coordinates>::each_joint(const Real& t, const Real* q, const Real* v, F f) const {
    JointRows rows;
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
        const Joint& joint = model_.joints[j];
        write_rows(joint, t, Layout::motion(q, v, joint.first), Layout::motion(q, v, joint.second), rows);
        f(j, rows);
    }
}

template <class Coordinates>
void GeneralRows<Coordinates>::positions(const Real& t, const Real* q, Real* phi) const {
    each_joint(t, q, nullptr, [&](std::size_t j, const JointRows& rows) {
        for (int k = 0; k < places_.position_rows_of_joint(j); ++k) phi[row(j, k)] = rows.phi[k];
    });
}

template <class Coordinates>
void GeneralRows<Coordinates>::velocities(const Real& t, const Real* q, const Real* v, int share,
                                          Real* residual) const {
    each_joint(t, q, v, [&](std::size_t j, const JointRows& rows) {
        const Joint& joint = model_.joints[j];
        const Motion first = Layout::motion(q, v, joint.first), second = Layout::motion(q, v, joint.second);
        for (int k = 0; k < rows.count; ++k) {
            Real sum = share * rows.rate_bias[k];
            if (joint.first != ground)
                sum += rows.first.template block<3, 1>(0, k).dot(first.V) +
                       rows.first.template block<3, 1>(3, k).dot(first.omega);
            if (joint.second != ground)
                sum += rows.second.template block<3, 1>(0, k).dot(second.V) +
                       rows.second.template block<3, 1>(3, k).dot(second.omega);
            residual[row(j, k)] = sum;
        }
    });
}

template <class Coordinates>
void GeneralRows<Coordinates>::velocity_bias(const Real& t, const Real* q, Real* b) const {
    each_joint(t, q, nullptr, [&](std::size_t j, const JointRows& rows) {
        for (int k = 0; k < rows.count; ++k) b[row(j, k)] = rows.rate_bias[k];
    });
}

/// C v' = xi. A = R^T x'' differs from the coordinates' v_1' by what the turning of their axes adds.
template <class Coordinates>
void GeneralRows<Coordinates>::acceleration_bias(const Real& t, const Real* q, const Real* v, Real* xi) const {
    each_joint(t, q, v, [&](std::size_t j, const JointRows& rows) {
        const Joint& joint = model_.joints[j];
        const auto turning = [&](int body, const Mat6& side, int k) -> Real {
            if (body == ground) return 0;
            return -side.template block<3, 1>(0, k).dot(
                Coordinates::gyroscopic(Real(1), Layout::angular(v, body), Layout::linear(v, body)));
        };
        for (int k = 0; k < rows.count; ++k)
            xi[row(j, k)] = -rows.acceleration_bias[k] - turning(joint.first, rows.first, k) -
                            turning(joint.second, rows.second, k);
    });
}

template <class Coordinates>
void GeneralRows<Coordinates>::jacobian(const Real& t, const Real* q, Eigen::Map<MatX>& C) const {
    C.setZero();
    const auto add = [&](int row, int body, const Mat6& side, int k) {
        if (body == ground) return;
        const Vec3 force = side.template block<3, 1>(0, k), torque = side.template block<3, 1>(3, k);
        C.template block<1, 3>(row, 6 * body) = Coordinates::from_body(Layout::rotation(q, body), force).transpose();
        C.template block<1, 3>(row, 6 * body + 3) = torque.transpose();
    };
    each_joint(t, q, nullptr, [&](std::size_t j, const JointRows& rows) {
        for (int k = 0; k < rows.count; ++k) {
            add(row(j, k), model_.joints[j].first, rows.first, k);
            add(row(j, k), model_.joints[j].second, rows.second, k);
        }
    });
}

template <class Coordinates>
template <class Add>
void GeneralRows<Coordinates>::transpose(const Real& t, const Real* q, const Real* lambda, Add add) const {
    each_joint(t, q, nullptr, [&](std::size_t j, const JointRows& rows) {
        Vec6 mine = Vec6::Zero();
        for (int k = 0; k < rows.count; ++k) mine[k] = lambda[row(j, k)];
        const auto pull = [&](int body, const Mat6& side) {
            if (body == ground) return;
            const Vec6 wrench = side.leftCols(rows.count).lazyProduct(mine.head(rows.count));
            add(body, wrench.template head<3>(), wrench.template tail<3>());
        };
        pull(model_.joints[j].first, rows.first), pull(model_.joints[j].second, rows.second);
    });
}

template <class Coordinates>
template <class Mobility>
void GeneralRows<Coordinates>::complement_diagonal(const Real& t, const Real* q, Mobility mobility,
                                                   Real* diagonal) const {
    each_joint(t, q, nullptr, [&](std::size_t j, const JointRows& rows) {
        const auto of_side = [&](int body, const Mat6& side, int k) -> Real {
            if (body == ground) return 0;
            const Vec3 force = side.template block<3, 1>(0, k), torque = side.template block<3, 1>(3, k);
            return mobility(static_cast<std::size_t>(body), force, torque);
        };
        for (int k = 0; k < rows.count; ++k)
            diagonal[row(j, k)] =
                of_side(model_.joints[j].first, rows.first, k) + of_side(model_.joints[j].second, rows.second, k);
    });
}

template <class Coordinates>
void GeneralRows<Coordinates>::reactions(const Real& t, const Real* q, const Real* lambda, JointReaction* out) const {
    std::array<Real, most_rows> mine{};
    for (std::size_t j = 0; j < places_.joints(); ++j) {
        const Joint& joint = model_.joints[j];
        for (int k = 0; k < places_.rows_of_joint(j); ++k) mine[static_cast<std::size_t>(k)] = lambda[row(j, k)];
        out[j] = reaction_of(joint, t, Layout::motion(q, nullptr, joint.first),
                             Layout::motion(q, nullptr, joint.second), mine.data());
    }
}

template <class Coordinates>
void GeneralRows<Coordinates>::scale(Real* scale) const {
    for (std::size_t j = 0; j < places_.joints(); ++j)
        for (int k = 0; k < places_.rows_of_joint(j); ++k) scale[row(j, k)] = row_scale(model_, model_.joints[j], k);
}

template <class Coordinates>
void GeneralRows<Coordinates>::position_scale(const Real* q, Real* size) const {
    for (std::size_t j = 0; j < places_.joints(); ++j) {
        const Joint& joint = model_.joints[j];
        const Real length = PointRows<Coordinates>::reach(joint, q) + joint.length;
        for (int k = 0; k < places_.position_rows_of_joint(j); ++k)
            size[row(j, k)] = is_direction_row(joint.type, k) ? Real(2) : length;
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
