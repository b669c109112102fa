// SPDX-License-Identifier: BSD-3-Clause
//
// The primitive rows of joints (mechanics/parts/joint_type.hpp), a function each: residual, what is added to C v, and
// the forces that a unit multiplier exerts on both bodies. Sources: mechanics/joints/joint_rows.hpp.
#pragma once

#include "mechanics/joints/coordinate_rows.hpp"
#include "mechanics/joints/row_columns.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Writes row after row for the two motions of one joint.
class RowWriter : RowColumns {
  public:
    RowWriter(const Joint& joint, const Motion& first, const Motion& second, JointRows& rows)
        : RowColumns(joint, first, second, rows) {
        rows_.count = 0;
    }

    void write(const JointRow& row, const Real& t) {
        switch (row.primitive) {
            case Primitive::coincidence:
                return coincidence();
            case Primitive::along:
                return along(row.k);
            case Primitive::orthogonal:
                return orthogonal(row.i, row.k);
            case Primitive::distance:
                return distance(t);
            case Primitive::contact:
                return contact();
            default:
                return write_coordinate_row(row, joint_, t, first_, second_, rows_);
        }
    }

  private:
    /// d = 0.
    void coincidence() {
        for (int k = 0; k < 3; ++k) {
            const Vec3 e = Vec3::Unit(k);
            push(d_[k], 0, bias_[k]);
            act(first_, e, joint_.r_first, column(rows_.first)),
                act(second_, -e, joint_.r_second, column(rows_.second));
        }
    }

    /// b_k.d = 0. The force acts on both bodies at the point of the first.
    void along(int k) {
        const Vec3 b = joint_.axes_second.col(k), e = second_.direction(b), de = second_.direction_rate(b);
        push(e.dot(d_), 0, e.dot(bias_) + 2 * de.dot(rate_) + second_.direction_bias(b).dot(d_));
        const Vec3 arm = joint_.r_second + second_.R.transpose() * d_;
        act(first_, e, joint_.r_first, column(rows_.first)), act(second_, -e, arm, column(rows_.second));
    }

    /// a_i.b_k = 0, with rate (omega_first - omega_second).(a x b) in space axes.
    void orthogonal(int i, int k) {
        const Vec3 a = joint_.axes_first.col(i), b = joint_.axes_second.col(k);
        const Vec3 as = first_.direction(a), bs = second_.direction(b), normal = as.cross(bs);
        push(as.dot(bs), 0,
             first_.direction_bias(a).dot(bs) + 2 * first_.direction_rate(a).dot(second_.direction_rate(b)) +
                 as.dot(second_.direction_bias(b)));
        turn(first_, normal, column(rows_.first)), turn(second_, -normal, column(rows_.second));
    }

    /// |d| - L(t) = 0.
    void distance(const Real& t) {
        const Real length = d_.norm(), phase = joint_.frequency * t;
        const Vec3 n = d_ / length;
        const Real L = joint_.length * (1 + joint_.amplitude * sin(phase));
        const Real dL = joint_.length * joint_.amplitude * joint_.frequency * cos(phase);
        const Real ddL = -joint_.length * joint_.amplitude * joint_.frequency * joint_.frequency * sin(phase);
        const Real along = n.dot(rate_);
        push(length - L, -dL, n.dot(bias_) + (rate_.squaredNorm() - along * along) / length - ddL);
        act(first_, n, joint_.r_first, column(rows_.first)), act(second_, -n, joint_.r_second, column(rows_.second));
    }

    /// The contact of a disk on a plane: normal, then two tangential directions; the plane's minus the disk's.
    void contact() {
        const Vec3 b = joint_.axes_second.col(2), axis = second_.direction(b), axis_rate = second_.direction_rate(b);
        const Vec3 n = first_.direction(joint_.axes_first.col(2));
        const Vec3 s = n - n.dot(axis) * axis, ds = -n.dot(axis_rate) * axis - n.dot(axis) * axis_rate;
        const Real size = s.norm();
        const Vec3 c = -joint_.length / size * s, dc = -joint_.length / size * (ds - s.dot(ds) / (size * size) * s);
        const Vec3 omega = second_.R * second_.omega;
        const Vec3 bias = -second_.direction_bias(joint_.r_second) - omega.cross(dc);
        const Vec3 arm = joint_.r_second + second_.R.transpose() * c;
        for (const int k : {2, 0, 1}) {
            const Vec3 e = first_.direction(joint_.axes_first.col(k));
            push(k == 2 ? Real(e.dot(d_ - c)) : Real(0), 0, e.dot(bias));
            act(second_, -e, arm, column(rows_.second));
        }
    }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
