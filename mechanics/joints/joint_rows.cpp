// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/joints/joint_rows.hpp"

#include <algorithm>
#include <array>

#include "mechanics/model/scales.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

struct RowCounts {
    int all, position, lengths;
};

constexpr RowCounts counts(JointType type) {
    switch (type) {
        case JointType::spherical:
            return {3, 3, 3};
        case JointType::revolute:
            return {5, 5, 3};
        case JointType::universal:
            return {4, 4, 3};
        case JointType::prismatic:
            return {5, 5, 2};
        case JointType::cylindrical:
            return {4, 4, 2};
        case JointType::planar:
            return {3, 3, 1};
        case JointType::fixed:
            return {6, 6, 3};
        case JointType::distance:
            return {1, 1, 1};
        case JointType::rolling:
            return {3, 1, 3};
    }
    return {0, 0, 0};
}

/// Writes row after row for the two motions of one joint.
class RowWriter {
  public:
    auto column(Mat6& side) { return side.col(rows_.count - 1); }

    RowWriter(const Joint& joint, const Motion& first, const Motion& second, JointRows& rows)
        : joint_(joint), first_(first), second_(second), rows_(rows) {
        rows_.count = 0;
        d_ = first.point(joint.r_first) - second.point(joint.r_second);
        rate_ = first.point_velocity(joint.r_first) - second.point_velocity(joint.r_second);
        bias_ = first.direction_bias(joint.r_first) - second.direction_bias(joint.r_second);
    }

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
    void rolling() {
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

  private:
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

}  // namespace

int rows_of(JointType type) { return counts(type).all; }
int position_rows_of(JointType type) { return counts(type).position; }

bool all_spherical(const Model& model) {
    return std::all_of(model.joints.begin(), model.joints.end(),
                       [](const Joint& joint) { return joint.type == JointType::spherical; });
}

void write_rows(const Joint& joint, const Real& t, const Motion& first, const Motion& second, JointRows& rows) {
    RowWriter write(joint, first, second, rows);
    switch (joint.type) {
        case JointType::spherical:
            return write.coincidence();
        case JointType::revolute:
            return write.coincidence(), write.orthogonal(2, 0), write.orthogonal(2, 1);
        case JointType::universal:
            return write.coincidence(), write.orthogonal(2, 2);
        case JointType::prismatic:
            return write.along(0), write.along(1), write.orthogonal(2, 0), write.orthogonal(2, 1),
                   write.orthogonal(0, 1);
        case JointType::cylindrical:
            return write.along(0), write.along(1), write.orthogonal(2, 0), write.orthogonal(2, 1);
        case JointType::planar:
            return write.along(2), write.orthogonal(2, 0), write.orthogonal(2, 1);
        case JointType::fixed:
            return write.coincidence(), write.orthogonal(2, 0), write.orthogonal(2, 1), write.orthogonal(0, 1);
        case JointType::distance:
            return write.distance(t);
        case JointType::rolling:
            return write.rolling();
    }
}

bool is_direction_row(JointType type, int row) { return row >= counts(type).lengths; }

std::vector<ConstraintRow> constraint_rows(const Model& model) {
    std::vector<ConstraintRow> rows;
    for (const bool position : {true, false})
        for (std::size_t j = 0; j < model.joints.size(); ++j) {
            const JointType type = model.joints[j].type;
            for (int k = 0; k < rows_of(type); ++k)
                if ((k < position_rows_of(type)) == position)
                    rows.push_back({static_cast<int>(j), k + 1, is_direction_row(type, k)});
        }
    return rows;
}

/// Forces of rows along axes of the second body act at the point of the first: d x F about that of the second.
JointReaction reaction_of(const Joint& joint, const Real& t, const Motion& first, const Motion& second,
                          const Real* lambda) {
    JointRows rows;
    write_rows(joint, t, first, second, rows);
    const int lengths = counts(joint.type).lengths, directions = rows.count - lengths;
    const Eigen::Map<const VecX> multipliers(lambda, rows.count);
    JointReaction reaction;
    reaction.force = second.R * (rows.second.topLeftCorner(3, lengths) * -multipliers.head(lengths));
    reaction.torque = second.R * (rows.second.block(3, lengths, 3, directions) * -multipliers.tail(directions));
    if (lengths < 3 && directions > 0)
        reaction.torque += (first.point(joint.r_first) - second.point(joint.r_second)).cross(reaction.force);
    return reaction;
}

Real row_scale(const Model& model, const Joint& joint, int row) {
    return is_direction_row(joint.type, row) ? Real(1) : joint_length(model, joint);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
