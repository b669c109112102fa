// SPDX-License-Identifier: BSD-3-Clause
//
// What the writers of the rows of one joint share: d with its derivatives, and columns of wrenches.
#pragma once

#include "mechanics/joints/joint_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class RowColumns {
  protected:
    RowColumns(const Joint& joint, const Motion& first, const Motion& second, JointRows& rows)
        : joint_(joint), first_(first), second_(second), rows_(rows) {
        d_ = first.point(joint.r_first) - second.point(joint.r_second);
        rate_ = first.point_velocity(joint.r_first) - second.point_velocity(joint.r_second);
        bias_ = first.direction_bias(joint.r_first) - second.direction_bias(joint.r_second);
    }

    auto column(Mat6& side) { return side.col(rows_.count - 1); }
    void push(const Real& phi, const Real& rate_bias, const Real& acceleration_bias) {
        const int k = rows_.count++;
        rows_.phi[k] = phi, rows_.rate_bias[k] = rate_bias, rows_.acceleration_bias[k] = acceleration_bias;
    }
    /// Unit force e (space axes) at r (body axes).
    template <class Column>
    static void act(const Motion& body, const Vec3& e, const Vec3& r, Column column) {
        const Vec3 force = body.R.transpose() * e;
        column.template head<3>() = force, column.template tail<3>() = r.cross(force);
    }
    /// Unit torque e (space axes).
    template <class Column>
    static void turn(const Motion& body, const Vec3& e, Column column) {
        column.template head<3>().setZero(), column.template tail<3>() = body.R.transpose() * e;
    }

    const Joint& joint_;
    const Motion &first_, &second_;
    JointRows& rows_;
    Vec3 d_, rate_, bias_;  // d, d', and d'' where A = omega' = 0 for both bodies
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
