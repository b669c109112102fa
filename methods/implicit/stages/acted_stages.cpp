// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/stages/acted_stages.hpp"

#include <algorithm>
#include <utility>

namespace kreisel {
inline namespace KREISEL_PRECISION {

ActedStages::ActedStages(System& system, StageCoefficients coefficients, StageCentre centre)
    : ImplicitStages(system, std::move(coefficients), centre),
      space_(system),
      renewed_(k_),
      half_(VecX::Zero(2 * n_)),
      u_(half_),
      slope_(half_),
      centre_(static_cast<std::size_t>(system.state_group().size())),
      stage_(centre_) {}

Status ActedStages::slope_at_start(Real* rate, Real* f) {
    const Status status = space_.slope(t_, y_, slope_.data());
    std::copy_n(slope_.data() + n_, n_, f);
    space_.to_tangent(y_, slope_.data());
    std::copy_n(slope_.data() + n_, n_, rate);
    return status;
}

/// The last slopes make the step.
void ActedStages::accept(Real* y) {
    u_.setZero();
    add_offsets();
    for (Eigen::Index i = 0; i < stages_; ++i) {
        u_.head(n_) += h_ * coefficients_.b[i] * renewed_.col(i);
        u_.tail(n_) += h_ * coefficients_.b[i] * f_.col(i);
    }
    space_.group().append_exp(y, u_.data(), y);
}

/// (k, w) - (k', h f') with (k', f') = dexp^{-1}(F). Iterates may turn farther than the final step.
Status ActedStages::residual(const Real* turned, Real* r) {
    take(turned);
    find_centre();
    for (Eigen::Index i = 0; i < stages_; ++i) {
        place(i);
        if (const Status status = slope(t_ + coefficients_.c[i] * h_); status != Status::ok) return status;
        renewed_.col(i) = slope_.head(n_), f_.col(i) = slope_.tail(n_);
        difference_ = k_.col(i) - renewed_.col(i);
        give(difference_, r + i * n_);
        difference_ = w_.col(i) - h_ * f_.col(i);
        give(difference_, r + (stages_ + i) * n_);
    }
    return Status::ok;
}

Status ActedStages::slope(const Real& t) {
    space_.group().append_exp(centre_.data(), u_.data(), stage_.data());
    if (const Status status = space_.slope(t, stage_.data(), slope_.data()); status != Status::ok) return status;
    const bool inside = space_.group().dexpinv_left(u_.data(), slope_.data(), slope_.data());
    return inside ? Status::ok : Status::left_chart;
}

void ActedStages::find_centre() {
    if (!around_middle_) {
        std::copy_n(y_, centre_.size(), centre_.begin());
        return;
    }
    half_.setZero();
    for (Eigen::Index i = 0; i < stages_; ++i) {
        half_.head(n_) += h_ / 2 * coefficients_.b[i] * k_.col(i);
        half_.tail(n_) += coefficients_.b[i] / 2 * w_.col(i);
    }
    space_.group().append_exp(y_, half_.data(), centre_.data());
}

/// u_i of k_ and w_.
void ActedStages::place(Eigen::Index i) {
    u_ = -half_;
    add_offsets();
    for (Eigen::Index j = 0; j < stages_; ++j) {
        u_.head(n_) += h_ * coefficients_.a(i, j) * k_.col(j);
        u_.tail(n_) += coefficients_.a_hat(i, j) * w_.col(j);
    }
}

void ActedStages::add_offsets() {
    if (has_offsets()) u_.head(n_) += position_offset, u_.tail(n_) += velocity_offset;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
