// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/joints/coordinate_rows.hpp"

#include <stdexcept>

#include "mechanics/joints/row_columns.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class CoordinateRows : RowColumns {
  public:
    CoordinateRows(const Joint& joint, const Motion& first, const Motion& second, JointRows& rows)
        : RowColumns(joint, first, second, rows) {}

    void write(const JointRow& row, const Real& t) {
        switch (row.primitive) {
            case Primitive::shift:
                return shift(joint_.shift.at(t));
            case Primitive::turn:
                return turned(joint_.turn.at(t));
            case Primitive::helix:
                return helix();
            default:
                throw std::logic_error("a row that holds no coordinate");
        }
    }

  private:
    /// b_3.d + f = 0. The force acts on both bodies at the point of the first.
    void shift(const Prescribed::Value& f) {
        const Vec3 b = joint_.axes_second.col(2), e = second_.direction(b), de = second_.direction_rate(b);
        push(e.dot(d_) + f.f, f.rate, e.dot(bias_) + 2 * de.dot(rate_) + second_.direction_bias(b).dot(d_) + f.second);
        const Vec3 arm = joint_.r_second + second_.R.transpose() * d_;
        act(first_, e, joint_.r_first, column(rows_.first)), act(second_, -e, arm, column(rows_.second));
    }

    /// The angle atan2(S, C) = 0 of S = a.b_2 and C = a.b_1, where a = a_1(f) turns in the first body.
    void turned(const Prescribed::Value& f) {
        const Vec3 a1 = joint_.axes_first.col(0), a2 = joint_.axes_first.col(1);
        const Real c = cos(f.f), s = sin(f.f);
        const Vec3 a = c * a1 + s * a2, across = c * a2 - s * a1;  // across is da/df
        const Vec3 as = first_.direction(a), cs = first_.direction(across);
        const Vec3 rate = first_.direction_rate(a) + f.rate * cs;
        const Vec3 bias = first_.direction_bias(a) + 2 * f.rate * first_.direction_rate(across) + f.second * cs -
                          f.rate * f.rate * as;
        struct Product {
            Real value, rate, bias, slope;  // a.b, its rates, and its derivative in f
            Vec3 normal;
        };
        const auto with = [&](int k) -> Product {
            const Vec3 b = joint_.axes_second.col(k), bs = second_.direction(b), db = second_.direction_rate(b);
            return {as.dot(bs), rate.dot(bs) + as.dot(db),
                    bias.dot(bs) + 2 * rate.dot(db) + as.dot(second_.direction_bias(b)), cs.dot(bs), as.cross(bs)};
        };
        const Product S = with(1), C = with(0);
        const Real square = S.value * S.value + C.value * C.value, cosine = C.value / square, sine = S.value / square;
        const Real growth = 2 * (sine * S.rate + cosine * C.rate);
        slope_ = cosine * S.slope - sine * C.slope;
        push(atan2(S.value, C.value), slope_ * f.rate,
             cosine * S.bias - sine * C.bias - growth * (cosine * S.rate - sine * C.rate));
        const Vec3 normal = cosine * S.normal - sine * C.normal;
        turn(first_, normal, column(rows_.first)), turn(second_, -normal, column(rows_.second));
    }

    /// The same with f = -2 pi b_3.d / lead, on which the row depends through the force of `along`.
    void helix() {
        const Vec3 b = joint_.axes_second.col(2), e = second_.direction(b), de = second_.direction_rate(b);
        const Real pitch = -2 * pi() / joint_.lead;
        turned({pitch * e.dot(d_), pitch * (e.dot(rate_) + de.dot(d_)),
                pitch * (e.dot(bias_) + 2 * de.dot(rate_) + second_.direction_bias(b).dot(d_))});
        rows_.rate_bias[rows_.count - 1] = 0;
        const Vec3 force = pitch * slope_ * e, arm = joint_.r_second + second_.R.transpose() * d_;
        Vec6 wrench;
        act(first_, force, joint_.r_first, wrench), column(rows_.first) += wrench;
        act(second_, -force, arm, wrench), column(rows_.second) += wrench;
    }

    Real slope_ = 0;  // of the last angle in f
};

}  // namespace

void write_coordinate_row(const JointRow& row, const Joint& joint, const Real& t, const Motion& first,
                          const Motion& second, JointRows& rows) {
    CoordinateRows(joint, first, second, rows).write(row, t);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
