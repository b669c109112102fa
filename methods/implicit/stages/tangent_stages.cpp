// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/stages/tangent_stages.hpp"

#include <algorithm>
#include <utility>

namespace kreisel {
inline namespace KREISEL_PRECISION {

TangentStages::TangentStages(System& system, StageCoefficients coefficients, StageCentre centre)
    : ImplicitStages(system, std::move(coefficients), centre),
      renewed_(k_),
      half_(difference_),
      u_(difference_),
      stage_v_(difference_),
      centre_(static_cast<std::size_t>(system.group().size())),
      stage_q_(centre_) {}

Status TangentStages::slope_at_start(Real* rate, Real* f) {
    const Status status = system_.evaluate(t_, y_, system_.v(y_), f);
    std::copy_n(f, n_, rate);
    return status;
}

void TangentStages::accept(Real* y) {
    Eigen::Map<VecX> v(system_.v(y), n_);
    if (has_offsets()) v += velocity_offset;
    for (Eigen::Index i = 0; i < stages_; ++i) v += h_ * coefficients_.b[i] * f_.col(i);
    u_ = 2 * half_;
    if (!around_middle_)
        for (Eigen::Index i = 0; i < stages_; ++i) u_ += h_ * coefficients_.b[i] * k_.col(i);
    if (has_offsets()) u_ += position_offset;
    system_.group().append_exp(y, u_.data(), y);
}

/// k - dexp^{-1}(V) and w - h f. Iterates may turn farther than the final step: only the last one is checked, at
/// the end of the step.
Status TangentStages::residual(const Real* turned, Real* r) {
    take(turned);
    find_centre();
    if (!around_middle_)
        if (const Status status = renew_slopes(r); status != Status::ok) return status;
    for (Eigen::Index i = 0; i < stages_; ++i) {
        const Status status = stage(i, r + i * n_, r + (stages_ + i) * n_);
        if (status != Status::ok && status != Status::turn_lost) return status;
    }
    return Status::ok;
}

void TangentStages::find_centre() {
    if (!around_middle_) {
        std::copy_n(y_, centre_.size(), centre_.begin());
        return;
    }
    half_.setZero();
    for (Eigen::Index i = 0; i < stages_; ++i) half_ += h_ / 2 * coefficients_.b[i] * k_.col(i);
    system_.group().append_exp(y_, half_.data(), centre_.data());
}

/// u_i of k_, and V_i.
void TangentStages::place(Eigen::Index i) {
    u_ = -half_;
    stage_v_ = Eigen::Map<const VecX>(system_.v(y_), n_);
    if (has_offsets()) u_ += position_offset, stage_v_ += velocity_offset;
    for (Eigen::Index j = 0; j < stages_; ++j) {
        u_ += h_ * coefficients_.a(i, j) * k_.col(j);
        stage_v_ += coefficients_.a_hat(i, j) * w_.col(j);
    }
}

/// The k that positions follow from: those that the velocities make. Stiff forces then see positions that fit to w,
/// however rough the k of an iterate are.
Status TangentStages::renew_slopes(Real* of_positions) {
    for (Eigen::Index i = 0; i < stages_; ++i) {
        place(i);
        if (!system_.group().dexpinv_left(u_.data(), stage_v_.data(), renewed_.col(i).data()))
            return Status::left_chart;
    }
    for (Eigen::Index i = 0; i < stages_; ++i) {
        difference_ = k_.col(i) - renewed_.col(i);
        give(difference_, of_positions + i * n_);
    }
    k_ = renewed_;
    return Status::ok;
}

Status TangentStages::stage(Eigen::Index i, Real* of_position, Real* of_velocity) {
    place(i);
    system_.group().append_exp(centre_.data(), u_.data(), stage_q_.data());
    if (around_middle_) {
        if (!system_.group().dexpinv_left(u_.data(), stage_v_.data(), difference_.data())) return Status::left_chart;
        difference_ = k_.col(i) - difference_;
        give(difference_, of_position);
    }
    const Status status =
        system_.evaluate(t_ + coefficients_.c[i] * h_, stage_q_.data(), stage_v_.data(), f_.col(i).data());
    difference_ = w_.col(i) - h_ * f_.col(i);
    give(difference_, of_velocity);
    return status;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
