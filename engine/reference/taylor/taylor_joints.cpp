// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/taylor_joints.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Of an arm or of the body, whichever is larger; the ground has neither.
Real length_on(const BodySeries& body, const Vec3& arm) {
    return body.is_fixed() ? Real(0) : max(body.radius(), Real(arm.norm()));
}

}  // namespace

JointSeries::JointSeries(const Joint& joint, BodySeries& first, BodySeries& second)
    : ends_(joint, first, second),
      points_(point_rows(joint, ends_)),
      force_(ends_.d),
      length_(max(joint.length, max(length_on(first, joint.r_first), length_on(second, joint.r_second)))) {
    for (const JointRow& row : joint.type->rows)
        if (row.primitive == Primitive::orthogonal) turns_.emplace_back(joint, row, ends_);
    lambda_.assign(static_cast<std::size_t>(forces()) + turns_.size(), Scalars(ends_.d.size(), Real(0)));
}

void JointSeries::start(const Real& t) {
    if (points_) points_->start(t);
    follow(0), follow(1);
}

void JointSeries::follow(std::size_t i) {
    ends_.follow(i);
    if (points_) points_->follow(ends_, i);
    for (TurnRow& row : turns_) row.follow(i);
}

void JointSeries::react(std::size_t k) {
    for (Scalars& lambda : lambda_) lambda[k] = 0;
    force_[k].setZero();
    Vec3 couple = Vec3::Zero();
    if (points_) {
        points_->direct(ends_, k);
        for (int r = 0; points_->turns() && r < forces(); ++r)
            force_[k] += product(lambda_[static_cast<std::size_t>(r)], points_->n(r), k);
    }
    for (std::size_t r = 0; r < turns_.size(); ++r) {
        turns_[r].direct(k);
        couple += product(lambda_[static_cast<std::size_t>(forces()) + r], turns_[r].t(), k);
    }
    const auto moment = [&](const Vectors& lever) { return Vec3(cross(lever, force_, k)); };
    if (!second().is_fixed()) second().act(force_[k], points_ ? Vec3(moment(points_->lever()) + couple) : couple, k);
    if (!first().is_fixed()) first().act(-force_[k], -moment(ends_.arm_first.series()) - couple, k);
}

Real JointSeries::acceleration(int row, std::size_t k) const {
    return is_force(row) ? points_->acceleration(ends_, row, k) : turn_row(row).acceleration(k);
}

JointSeries::Wrench JointSeries::on_first(int row) const {
    if (!is_force(row)) return {Vec3::Zero(), turn_row(row).t()[0]};
    const Vec3& n = points_->n(row)[0];
    return {n, ends_.arm_first[0].cross(n)};
}

JointSeries::Wrench JointSeries::on_second(int row) const {
    if (!is_force(row)) return {Vec3::Zero(), -turn_row(row).t()[0]};
    const Vec3 n = -points_->n(row)[0];
    return {n, points_->lever()[0].cross(n)};
}

void JointSeries::set_multiplier(int row, std::size_t k, const Real& lambda) {
    lambda_[static_cast<std::size_t>(row)][k] = lambda;
    if (is_force(row)) force_[k] += lambda * points_->n(row)[0];
}

Real JointSeries::multiplier(int row, const Real& s) const {
    const Scalars& lambda = lambda_[static_cast<std::size_t>(row)];
    Real sum = 0;
    for (std::size_t k = lambda.size(); k-- > 0;) sum = sum * s + lambda[k];
    return sum;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
