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
                return turned(joint_.axes_first.col(0), joint_.axes_first.col(1), joint_.turn.at(t));
            case Primitive::helix:
                return helix();
            case Primitive::rack:
                return rack();
            case Primitive::mesh:
                return mesh();
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

    /// A scalar product: its value, its rate, and its second rate where A = omega' = 0 for both bodies.
    struct Product {
        Real value, rate, bias;
    };
    /// The angle atan2(S, C) of two of them, alike; its derivative is cosine dS - sine dC.
    struct Angle {
        Real cosine, sine;
        Product angle;
        Angle(const Product& S, const Product& C) {
            const Real square = S.value * S.value + C.value * C.value;
            cosine = C.value / square, sine = S.value / square;
            const Real rate = cosine * S.rate - sine * C.rate;
            angle = {atan2(S.value, C.value), rate,
                     cosine * S.bias - sine * C.bias - 2 * (sine * S.rate + cosine * C.rate) * rate};
        }
    };

    /// The angle f - theta = atan2(a.b_2, a.b_1), where a = cos f a1 + sin f a2 turns in the first body.
    void turned(const Vec3& a1, const Vec3& a2, const Prescribed::Value& f) {
        const Real c = cos(f.f), s = sin(f.f);
        const Vec3 a = c * a1 + s * a2, across = c * a2 - s * a1;  // across is da/df
        const Vec3 as = first_.direction(a), cs = first_.direction(across);
        const Vec3 rate = first_.direction_rate(a) + f.rate * cs;
        const Vec3 bias = first_.direction_bias(a) + 2 * f.rate * first_.direction_rate(across) + f.second * cs -
                          f.rate * f.rate * as;
        const auto with = [&](const Vec3& b) -> Product {
            const Vec3 bs = second_.direction(b), db = second_.direction_rate(b);
            return {as.dot(bs), rate.dot(bs) + as.dot(db),
                    bias.dot(bs) + 2 * rate.dot(db) + as.dot(second_.direction_bias(b))};
        };
        const Vec3 b1 = joint_.axes_second.col(0), b2 = joint_.axes_second.col(1);
        const Angle theta(with(b2), with(b1));
        const Vec3 b = theta.cosine * second_.direction(b2) - theta.sine * second_.direction(b1);
        slope_ = cs.dot(b);
        push(theta.angle.value, slope_ * f.rate, theta.angle.bias);
        const Vec3 normal = as.cross(b);
        turn(first_, normal, column(rows_.first)), turn(second_, -normal, column(rows_.second));
    }

    /// e.d for an axis e of a body.
    Product component(const Motion& body, const Vec3& axis) const {
        const Vec3 e = body.direction(axis), de = body.direction_rate(axis);
        return {e.dot(d_), e.dot(rate_) + de.dot(d_),
                e.dot(bias_) + 2 * de.dot(rate_) + body.direction_bias(axis).dot(d_)};
    }
    /// Adds to the last row what it has through components of d along axes of one body, with the gradient g in d (space
    /// axes). For axes of the second body the force acts at the point of the first, and the other way round.
    void pull(const Vec3& g, bool of_second) {
        const Vec3 none = Vec3::Zero();
        const Vec3 from_first = of_second ? none : Vec3(first_.R.transpose() * d_);
        const Vec3 from_second = of_second ? Vec3(second_.R.transpose() * d_) : none;
        Vec6 wrench;
        act(first_, g, joint_.r_first - from_first, wrench.col(0)), column(rows_.first) += wrench;
        act(second_, -g, joint_.r_second + from_second, wrench.col(0)), column(rows_.second) += wrench;
    }

    /// f - theta = 0 with an f that grows by `radians` with x, the component of d along an axis of a body.
    void turned_by(const Vec3& a1, const Vec3& a2, const Real& radians, const Vec3& axis, bool of_second) {
        const Motion& body = of_second ? second_ : first_;
        const Product x = component(body, axis);
        turned(a1, a2, {radians * x.value, radians * x.rate, radians * x.bias});
        rows_.rate_bias[rows_.count - 1] = 0;
        pull(radians * slope_ * body.direction(axis), of_second);
    }
    void helix() {
        turned_by(joint_.axes_first.col(0), joint_.axes_first.col(1), -2 * pi() / joint_.lead,
                  joint_.axes_second.col(2), true);
    }
    void rack() {
        turned_by(joint_.axes_first.col(2), -joint_.axes_first.col(1), 2 * pi() / joint_.lead, joint_.axes_first.col(2),
                  false);
    }

    /// (z_1 psi_1 + z_2 psi_2) / z_2 = 0, the sum within half a turn.
    void mesh() {
        const auto angle_of_line = [&](const Motion& body, const Mat3& axes) {
            return Angle(component(body, axes.col(1)), component(body, axes.col(0)));
        };
        const auto gradient = [](const Angle& psi, const Motion& body, const Mat3& axes) -> Vec3 {
            return body.direction(psi.cosine * axes.col(1) - psi.sine * axes.col(0));
        };
        const Angle first = angle_of_line(first_, joint_.axes_first),
                    second = angle_of_line(second_, joint_.axes_second);
        const Real z1 = joint_.teeth[0], z2 = joint_.teeth[1], ratio = z1 / z2;
        const Real sum = z1 * first.angle.value + z2 * second.angle.value;
        push(atan2(sin(sum), cos(sum)) / z2, 0, ratio * first.angle.bias + second.angle.bias);
        column(rows_.first).setZero(), column(rows_.second).setZero();
        pull(ratio * gradient(first, first_, joint_.axes_first), false);
        pull(gradient(second, second_, joint_.axes_second), true);
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
