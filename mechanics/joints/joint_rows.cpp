// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/joints/joint_rows.hpp"

#include <algorithm>

#include "mechanics/joints/row_writer.hpp"
#include "mechanics/model/scales.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

bool all_spherical(const Model& model) {
    return std::all_of(model.joints.begin(), model.joints.end(),
                       [](const Joint& joint) { return joint.type->is_ball(); });
}

void write_rows(const Joint& joint, const Real& t, const Motion& first, const Motion& second, JointRows& rows) {
    RowWriter writer(joint, first, second, rows);
    for (const JointRow& row : joint.type->rows) writer.write(row, t);
}

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

namespace {

/// Moves what keeps prescribed coordinates from a reaction to what drives the joint: the force of the row `shift`, and
/// of the torque of the row `turn` the part about the axis, which is all of it where the row is met.
void take_drive(const Joint& joint, const JointRows& rows, const Motion& second, const Real* lambda,
                JointReaction& reaction) {
    const Vec3 axis = second.direction(joint.axes_second.col(2));
    if (const int k = joint.type->row_of(Primitive::shift); k >= 0) {
        reaction.driving_force = lambda[k];
        reaction.force -= lambda[k] * axis;
    }
    if (const int k = joint.type->row_of(Primitive::turn); k >= 0) {
        reaction.driving_torque = -lambda[k] * axis.dot(second.R * rows.second.col(k).tail<3>());
        reaction.torque -= reaction.driving_torque * axis;
    }
}

/// Adds the force of the last row, which compares directions and depends on d too, at `point` (space axes), and takes
/// its moment about the mass centre, which the row's column has beside the torque.
void add_thrust(const JointRows& rows, const Motion& second, const Vec3& point, const Real& lambda,
                JointReaction& reaction) {
    const Vec3 force = second.R * (-lambda * rows.second.col(rows.count - 1).head<3>());
    reaction.force += force;
    reaction.torque -= (point - second.x).cross(force);
}

bool thrusts(JointType type) {
    return type->has(Primitive::helix) || type->has(Primitive::rack) || type->has(Primitive::mesh);
}

}  // namespace

/// Forces of rows along axes of the second body act at the point of the first: d x F about that of the second.
JointReaction reaction_of(const Joint& joint, const Real& t, const Motion& first, const Motion& second,
                          const Real* lambda) {
    JointRows rows;
    write_rows(joint, t, first, second, rows);
    const int lengths = joint.type->length_count, directions = rows.count - lengths;
    const Eigen::Map<const VecX> multipliers(lambda, rows.count);
    JointReaction reaction;
    reaction.force = second.R * (rows.second.topLeftCorner(3, lengths) * -multipliers.head(lengths));
    reaction.torque = second.R * (rows.second.block(3, lengths, 3, directions) * -multipliers.tail(directions));
    const bool along = joint.type->has(Primitive::along);
    if (thrusts(joint.type))
        add_thrust(rows, second, along ? first.point(joint.r_first) : second.point(joint.r_second),
                   lambda[rows.count - 1], reaction);
    if (along) reaction.torque += (first.point(joint.r_first) - second.point(joint.r_second)).cross(reaction.force);
    take_drive(joint, rows, second, lambda, reaction);
    return reaction;
}

Real row_scale(const Model& model, const Joint& joint, int row) {
    return is_direction_row(joint.type, row) ? Real(1) : joint_length(model, joint);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
