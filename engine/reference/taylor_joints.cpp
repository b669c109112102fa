// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor_joints.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Vectors vectors(const BodySeries& body) { return Vectors(body.R.size(), Vec3::Zero()); }
/// Of an arm or of the body, whichever is larger; the ground has neither.
Real length_on(const BodySeries& body, const Vec3& arm) {
    return body.is_fixed() ? Real(0) : max(body.radius(), Real(arm.norm()));
}
Scalars scalars(const BodySeries& body) { return Scalars(body.R.size(), Real(0)); }

}  // namespace

JointSeries::JointSeries(const Joint& joint, BodySeries& first, BodySeries& second)
    : joint_(joint),
      first_(first),
      second_(second),
      arm_first_(first, joint.r_first),
      arm_second_(second, joint.r_second),
      d_(vectors(first)),
      lever_(d_),
      force_(d_),
      square_(scalars(first)),
      length_(square_),
      law_(square_),
      disk_(second, joint.axes_second.col(2)),
      cosine_(square_),
      s_(d_),
      unit_(d_),
      omega_(d_) {
    add_rows();
    lambda_.assign(static_cast<std::size_t>(rows()), square_);
}

void JointSeries::hold(Hold how, std::initializer_list<int> axes) {
    hold_ = how;
    for (const int k : axes) {
        const Vec3 axis = how == Hold::along     ? Vec3(joint_.axes_second.col(k))
                          : how == Hold::contact ? Vec3(joint_.axes_first.col(k))
                                                 : Vec3(Vec3::Unit(k));
        forces_.push_back({axis, d_});
        if (how == Hold::coincidence || how == Hold::contact) forces_.back().n[0] = axis;
    }
}

void JointSeries::align(std::initializer_list<std::pair<int, int>> axes) {
    for (const auto& [i, k] : axes)
        turns_.push_back({{first_, joint_.axes_first.col(i)}, {second_, joint_.axes_second.col(k)}, d_});
}

void JointSeries::add_rows() {
    switch (joint_.type) {
        case JointType::spherical:
            return hold(Hold::coincidence, {0, 1, 2});
        case JointType::revolute:
            return hold(Hold::coincidence, {0, 1, 2}), align({{2, 0}, {2, 1}});
        case JointType::universal:
            return hold(Hold::coincidence, {0, 1, 2}), align({{2, 2}});
        case JointType::prismatic:
            return hold(Hold::along, {0, 1}), align({{2, 0}, {2, 1}, {0, 1}});
        case JointType::cylindrical:
            return hold(Hold::along, {0, 1}), align({{2, 0}, {2, 1}});
        case JointType::planar:
            return hold(Hold::along, {2}), align({{2, 0}, {2, 1}});
        case JointType::fixed:
            return hold(Hold::coincidence, {0, 1, 2}), align({{2, 0}, {2, 1}, {0, 1}});
        case JointType::distance:
            return hold(Hold::distance, {0});
        case JointType::rolling:
            return hold(Hold::contact, {2, 0, 1});
    }
}

Real JointSeries::scale(int row) const {
    const Real largest =
        max(joint_.length, max(length_on(first_, joint_.r_first), length_on(second_, joint_.r_second)));
    return is_force(row) && largest > 0 ? largest : Real(1);
}

void JointSeries::start(const Real& t) {
    modulate(joint_.amplitude, joint_.frequency, t, law_);
    for (Real& coefficient : law_) coefficient *= joint_.length;
    follow(0), follow(1);
}

void JointSeries::follow(std::size_t i) {
    arm_first_.update(i), arm_second_.update(i);
    d_[i] = first_.x[i] + arm_first_[i] - second_.x[i] - arm_second_[i];
    lever_[i] = arm_second_[i];
    if (hold_ == Hold::along) {
        lever_[i] += d_[i];
        for (ForceRow& row : forces_) row.n[i] = second_.R[i] * row.axis;
    }
    if (hold_ == Hold::distance) {
        square_[i] = dot(d_, d_, i);
        length_[i] = square_root(square_, length_, i);
    }
    if (hold_ == Hold::contact) follow_contact(i);
    for (TurnRow& row : turns_) row.a.update(i), row.b.update(i);
}

/// s = n - (n . b) b and c = -L s/|s|; omega stands one coefficient below R.
void JointSeries::follow_contact(std::size_t i) {
    const Vec3& n = forces_[0].axis;
    disk_.update(i);
    cosine_[i] = n.dot(disk_[i]);
    s_[i] = product(cosine_, disk_.series(), i);
    if (i == 0) s_[i] -= n;
    square_[i] = dot(s_, s_, i);
    length_[i] = square_root(square_, length_, i);
    unit_[i] = quotient(s_, length_, unit_, i);
    lever_[i] += joint_.length * unit_[i];
    if (i > 0) omega_[i - 1] = product(second_.R, second_.omega, i - 1);
}

void JointSeries::react(std::size_t k) {
    for (Scalars& lambda : lambda_) lambda[k] = 0;
    force_[k].setZero();
    Vec3 couple = Vec3::Zero();
    if (hold_ == Hold::distance) forces_[0].n[k] = quotient(d_, length_, forces_[0].n, k);
    if (hold_ == Hold::along || hold_ == Hold::distance)
        for (std::size_t r = 0; r < forces_.size(); ++r) force_[k] += product(lambda_[r], forces_[r].n, k);
    for (std::size_t r = 0; r < turns_.size(); ++r) {
        turns_[r].t[k] = cross(turns_[r].a.series(), turns_[r].b.series(), k);
        couple += product(lambda_[forces_.size() + r], turns_[r].t, k);
    }
    if (!second_.is_fixed()) second_.act(force_[k], cross(lever_, force_, k) + couple, k);
    if (!first_.is_fixed()) first_.act(-force_[k], -cross(arm_first_.series(), force_, k) - couple, k);
}

Real JointSeries::acceleration(int row, std::size_t k) const {
    const std::size_t i = k + 2;
    const Real twice = real(k + 1) * real(k + 2);
    if (!is_force(row)) return twice * dot(turn_row(row).a.series(), turn_row(row).b.series(), i);
    const Vec3& axis = force_row(row).axis;
    switch (hold_) {
        case Hold::coincidence:
            return twice * axis.dot(d_[i]);
        case Hold::along:
            return twice * dot(force_row(row).n, d_, i);
        case Hold::distance:
            return twice * (length_[i] - law_[i]);
        case Hold::contact:
            break;
    }
    if (!is_velocity(row)) return -twice * axis.dot(second_.x[i] + lever_[i]);
    return -real(k + 1) * axis.dot(rate(second_.x, k + 1) + cross(omega_, lever_, k + 1));
}

JointSeries::Wrench JointSeries::on_first(int row) const {
    if (!is_force(row)) return {Vec3::Zero(), turn_row(row).t[0]};
    const Vec3& n = force_row(row).n[0];
    return {n, arm_first_[0].cross(n)};
}

JointSeries::Wrench JointSeries::on_second(int row) const {
    if (!is_force(row)) return {Vec3::Zero(), -turn_row(row).t[0]};
    const Vec3 n = -force_row(row).n[0];
    return {n, lever_[0].cross(n)};
}

void JointSeries::set_multiplier(int row, std::size_t k, const Real& lambda) {
    lambda_[static_cast<std::size_t>(row)][k] = lambda;
    if (is_force(row)) force_[k] += lambda * force_row(row).n[0];
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
