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
      lever_(ends_.d),
      force_(ends_.d),
      length_(max(joint.length, max(length_on(first, joint.r_first), length_on(second, joint.r_second)))) {
    for (const JointRow& row : joint.type->rows)
        if (auto direction = direction_row(joint, row, ends_)) directions_.push_back(std::move(direction));
    lambda_.assign(static_cast<std::size_t>(forces()) + directions_.size(), Scalars(ends_.d.size(), Real(0)));
}

void JointSeries::start(const Real& t) {
    if (points_) points_->start(t);
    for (const auto& row : directions_) row->start(t);
    follow(0), follow(1);
}

void JointSeries::follow(std::size_t i) {
    ends_.follow(i);
    lever_[i] = ends_.arm_second[i] + ends_.d[i];
    if (points_) points_->follow(ends_, i);
    for (const auto& row : directions_) row->follow(ends_, i);
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
    for (std::size_t r = 0; r < directions_.size(); ++r) {
        DirectionRowSeries& row = *directions_[r];
        const Scalars& lambda = lambda_[static_cast<std::size_t>(forces()) + r];
        row.direct(ends_, k);
        couple += product(lambda, row.t(), k);
        if (row.n()) force_[k] += product(lambda, *row.n(), k);
    }
    const auto moment = [&](const Vectors& lever) { return Vec3(cross(lever, force_, k)); };
    if (!second().is_fixed()) second().act(force_[k], moment(lever()) + couple, k);
    if (!first().is_fixed()) first().act(-force_[k], -moment(ends_.arm_first.series()) - couple, k);
}

Real JointSeries::acceleration(int row, std::size_t k) const {
    return is_force(row) ? points_->acceleration(ends_, row, k) : direction(row).acceleration(k);
}

JointSeries::Wrench JointSeries::on_first(int row) const {
    const Vec3 n = is_force(row) ? points_->n(row)[0] : thrust(row), moment = ends_.arm_first[0].cross(n);
    return {n, is_force(row) ? moment : Vec3(moment + direction(row).t()[0])};
}

JointSeries::Wrench JointSeries::on_second(int row) const {
    const Vec3 n = is_force(row) ? Vec3(-points_->n(row)[0]) : Vec3(-thrust(row));
    const Vec3 moment = lever()[0].cross(n);
    return {n, is_force(row) ? moment : Vec3(moment - direction(row).t()[0])};
}

void JointSeries::set_multiplier(int row, std::size_t k, const Real& lambda) {
    lambda_[static_cast<std::size_t>(row)][k] = lambda;
    force_[k] += lambda * (is_force(row) ? points_->n(row)[0] : thrust(row));
}

Real JointSeries::multiplier(int row, const Real& s) const {
    const Scalars& lambda = lambda_[static_cast<std::size_t>(row)];
    Real sum = 0;
    for (std::size_t k = lambda.size(); k-- > 0;) sum = sum * s + lambda[k];
    return sum;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
