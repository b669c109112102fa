// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/implicit_stages.hpp"

#include <algorithm>
#include <utility>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

ImplicitStages::ImplicitStages(System& system, StageCoefficients coefficients, StageCentre centre)
    : system_(system),
      coefficients_(std::move(coefficients)),
      around_middle_(centre == StageCentre::middle),
      n_(system.velocities()),
      stages_(coefficients_.b.size()),
      newton_(2 * n_ * stages_),
      scale_(system),
      remoteness_of_(system),
      past_(2 * n_ * stages_),
      turned_(VecX::Zero(2 * n_ * stages_)),
      weights_(VecX::Ones(turned_.size())),
      k_(MatX::Zero(n_, stages_)),
      w_(k_),
      f_(k_),
      renewed_(k_),
      half_(VecX::Zero(n_)),
      u_(half_),
      stage_v_(half_),
      difference_(half_),
      centre_(static_cast<std::size_t>(system.group().size())),
      stage_q_(centre_) {}

Status ImplicitStages::advance(const Real& t, const Real& h, Real* y) {
    t_ = t, h_ = h, q_ = y, v_ = system_.v(y);
    scale_.weigh(y);
    if (const Status status = guess(); status != Status::ok) return status;
    motion_ = scale_.of_motion(t, h, y);
    remoteness_ = remoteness_of_.measure(y);
    if (const Status status = iterate(); status != Status::ok) {
        past_.clear();
        return status;
    }
    past_.push(turned_);
    accept(y);
    return Status::ok;
}

void ImplicitStages::accept(Real* y) {
    Eigen::Map<VecX> v(system_.v(y), n_);
    if (has_offsets()) v += velocity_offset;
    for (Eigen::Index i = 0; i < stages_; ++i) v += h_ * coefficients_.b[i] * f_.col(i);
    u_ = 2 * half_;
    if (!around_middle_)
        for (Eigen::Index i = 0; i < stages_; ++i) u_ += h_ * coefficients_.b[i] * k_.col(i);
    if (has_offsets()) u_ += position_offset;
    system_.group().append_exp(y, u_.data(), y);
}

/// From the steps before, or from constant f at the start and where something is stiff.
Status ImplicitStages::guess() {
    if (h_ != known_h_) newton_.forget(), past_.clear();
    known_h_ = h_;
    if (!past_.empty() && !newton_.stiff()) {
        past_.guess(past_.best_degree(turned_.size()), turned_);
        return Status::ok;
    }
    const Status status = system_.evaluate(t_, q_, v_, f_.data());
    for (Eigen::Index i = 0; i < stages_; ++i) {
        difference_ = h_ * f_.col(0);
        scale_.to_space(q_, difference_.data(), slope_of_velocity(i));
        difference_ = Eigen::Map<const VecX>(v_, n_) + coefficients_.c[i] * difference_;
        scale_.to_space(q_, difference_.data(), slope_of_position(i));
    }
    return status;
}

/// From the guess, and where that leads nowhere, or out of the chart, from an unchanged velocity: springs that are
/// stiff make f swing.
Status ImplicitStages::iterate() {
    const Status status = newton_.solve(*this, weights_, turned_.data());
    if (status != Status::newton_failed && status != Status::left_chart) return status;
    turned_.setZero();
    for (Eigen::Index i = 0; i < stages_; ++i) scale_.to_space(q_, v_, slope_of_position(i));
    const Status again = newton_.solve(*this, weights_, turned_.data());
    return again == Status::newton_failed ? status : again;
}

/// k - dexp^{-1}(V) and w - h f. Iterates may turn farther than the final step: only the last one is checked, at
/// the end of the step.
Status ImplicitStages::residual(const Real* turned, Real* r) {
    for (Eigen::Index i = 0; i < stages_; ++i) {
        scale_.from_space(q_, turned + i * n_, k_.col(i).data());
        scale_.from_space(q_, turned + (stages_ + i) * n_, w_.col(i).data());
    }
    find_centre();
    if (!around_middle_)
        if (const Status status = renew_slopes(r); status != Status::ok) return status;
    for (Eigen::Index i = 0; i < stages_; ++i) {
        const Status status = stage(i, r + i * n_, r + (stages_ + i) * n_);
        if (status != Status::ok && status != Status::turn_lost) return status;
    }
    return Status::ok;
}

void ImplicitStages::find_centre() {
    if (!around_middle_) {
        std::copy_n(q_, centre_.size(), centre_.begin());
        return;
    }
    half_.setZero();
    for (Eigen::Index i = 0; i < stages_; ++i) half_ += h_ / 2 * coefficients_.b[i] * k_.col(i);
    system_.group().append_exp(q_, half_.data(), centre_.data());
}

/// u_i of k_, and V_i.
void ImplicitStages::place(Eigen::Index i) {
    u_ = -half_;
    stage_v_ = Eigen::Map<const VecX>(v_, n_);
    if (has_offsets()) u_ += position_offset, stage_v_ += velocity_offset;
    for (Eigen::Index j = 0; j < stages_; ++j) {
        u_ += h_ * coefficients_.a(i, j) * k_.col(j);
        stage_v_ += coefficients_.a_hat(i, j) * w_.col(j);
    }
}

/// The k that positions follow from: those that the velocities make. Stiff forces then see positions that fit to w,
/// however rough the k of an iterate are.
Status ImplicitStages::renew_slopes(Real* of_positions) {
    for (Eigen::Index i = 0; i < stages_; ++i) {
        place(i);
        if (!system_.group().dexpinv_left(u_.data(), stage_v_.data(), renewed_.col(i).data()))
            return Status::left_chart;
    }
    k_ -= renewed_;
    for (Eigen::Index i = 0; i < stages_; ++i) scale_.to_space(q_, k_.col(i).data(), of_positions + i * n_);
    k_ = renewed_;
    return Status::ok;
}

Status ImplicitStages::stage(Eigen::Index i, Real* of_position, Real* of_velocity) {
    place(i);
    system_.group().append_exp(centre_.data(), u_.data(), stage_q_.data());
    if (around_middle_) {
        if (!system_.group().dexpinv_left(u_.data(), stage_v_.data(), difference_.data())) return Status::left_chart;
        difference_ = k_.col(i) - difference_;
        scale_.to_space(q_, difference_.data(), of_position);
    }
    const Status status =
        system_.evaluate(t_ + coefficients_.c[i] * h_, stage_q_.data(), stage_v_.data(), f_.col(i).data());
    difference_ = w_.col(i) - h_ * f_.col(i);
    scale_.to_space(q_, difference_.data(), of_velocity);
    return status;
}

Real ImplicitStages::size() const {
    Real most = motion_;
    for (Eigen::Index i = 0; i < stages_; ++i) most = max(most, Real(abs(h_) * scale_.of_velocity(f_.col(i).data())));
    return most;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
