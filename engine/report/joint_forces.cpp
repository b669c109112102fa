// SPDX-License-Identifier: BSD-3-Clause
#include "engine/report/joint_forces.hpp"

#include <algorithm>

#include "engine/report/report.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Column column_of(const ConstraintRow& row, const std::vector<std::string>& joints) {
    return {"lambda." + joints[static_cast<std::size_t>(row.joint)] + "." + std::to_string(row.number),
            row.direction ? "N m" : "N"};
}

}  // namespace

JointForces::JointForces(System& system, const Model& model)
    : system_(system),
      rows_(system.constraint_rows()),
      joints_(model.joint_names()),
      multipliers_(rows_.size()),
      dv_(static_cast<std::size_t>(system.velocities())),
      scratch_(rows_.size()),
      reactions_(model.joints.size()) {
    const ConstraintRank rank = system.constraint_rank();
    redundant_ = rank.rank < rank.rows;
    for (const Joint& joint : model.joints)
        drives_.push_back({joint.type->has(Primitive::turn), joint.type->has(Primitive::shift)});
}

bool JointForces::find(const Real& t, const Real* y, const Real* own) {
    if (joints_.empty()) return true;
    const Real* v = system_.v(y);
    if (!rows_.empty() && (!own || redundant_)) {  // uniqueness of rows is known only after a solve
        ++evaluations_;
        if (system_.accelerations(t, y, v, dv_.data(), scratch_.data()) != Status::ok) return false;
    }
    if (!rows_.empty()) std::copy_n(own ? own : scratch_.data(), rows_.size(), multipliers_.begin());
    return system_.reactions(t, y, v, multipliers_.data(), reactions_.data()) == Status::ok;
}

std::vector<bool> JointForces::unique_joints() const {
    std::vector<bool> unique(joints_.size(), true);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (!is_unique(i)) unique[static_cast<std::size_t>(rows_[i].joint)] = false;
    return unique;
}

std::vector<Column> JointForces::columns() const {
    std::vector<Column> all;
    for (const ConstraintRow& row : rows_) all.push_back(column_of(row, joints_));
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const std::string& joint = joints_[j];
        for (int k = 1; k <= 3; ++k) all.push_back({"reaction." + joint + ".force." + std::to_string(k), "N"});
        for (int k = 1; k <= 3; ++k) all.push_back({"reaction." + joint + ".torque." + std::to_string(k), "N m"});
        each_drive(j, [&](const char* name, const char* unit, const Real&) {
            all.push_back({"drive." + joint + "." + name, unit});
        });
        if (redundant_) all.push_back({"reaction." + joint + ".unique", "1"});
    }
    return all;
}

void JointForces::append_values(bool found, std::vector<std::string>& row) const {
    const auto append = [&](const Real& x, bool known) {
        row.push_back(known && isfinite(x) ? to_text(x) : std::string());
    };
    for (std::size_t i = 0; i < rows_.size(); ++i) append(multipliers_[i], found && is_unique(i));
    const std::vector<bool> unique = unique_joints();
    for (std::size_t j = 0; j < reactions_.size(); ++j) {
        for (const Vec3& vector : {reactions_[j].force, reactions_[j].torque})
            for (const Real& x : vector) append(x, found);
        each_drive(j, [&](const char*, const char*, const Real& x) { append(x, found); });
        if (redundant_) append(unique[j] ? 1 : 0, found);
    }
}

void JointForces::report(ReportedState& state) const {
    for (const ConstraintRow& row : rows_) {
        const Column column = column_of(row, joints_);
        state.multiplier_names.push_back(column.name + " [" + column.unit + "]");
    }
    const std::vector<bool> unique = unique_joints();
    for (std::size_t j = 0; j < reactions_.size(); ++j) {
        const JointReaction& of_joint = reactions_[j];
        ReportedReaction reaction{joints_[j], to_numbers(of_joint.force), to_numbers(of_joint.torque), unique[j]};
        if (drives_[j].shift) reaction.driving_force = to_number(of_joint.driving_force);
        if (drives_[j].turn) reaction.driving_torque = to_number(of_joint.driving_torque);
        state.reactions.push_back(reaction);
    }
}

MultiplierDistance multiplier_distance(const std::vector<ConstraintRow>& rows, const std::vector<Real>& a,
                                       const std::vector<Real>& b) {
    MultiplierDistance squares;
    for (std::size_t i = 0; i < rows.size(); ++i)
        (rows[i].direction ? squares.torque : squares.force) += (a[i] - b[i]) * (a[i] - b[i]);
    return {sqrt(squares.force), sqrt(squares.torque)};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
