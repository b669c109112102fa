// SPDX-License-Identifier: BSD-3-Clause
#include "methods/symmetric_projection/projected_gauss.hpp"

#include "methods/implicit/stages/gauss_coefficients.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

ProjectedGauss::ProjectedGauss(System& system, const MotionScale& scale, int stages)
    : ProjectedStep(system, scale, 2 * stages),
      coefficients_(gauss_coefficients(stages)),
      stages_(stages),
      half_(moved_),
      stage_v_(moved_),
      f_(MatX::Zero(n_, stages)),
      stage_q_(start_) {}

void ProjectedGauss::guess(const VecX& change, Real* slopes) const {
    for (Eigen::Index i = 0; i < stages_; ++i) {
        Eigen::Map<VecX>(slopes + i * n_, n_) = start_velocity() + coefficients_.c[i] * change;
        Eigen::Map<VecX>(slopes + (stages_ + i) * n_, n_) = change;
    }
}

Real ProjectedGauss::largest_change() const {
    Real most = 0;
    for (Eigen::Index i = 0; i < stages_; ++i) most = max(most, scale_.of_velocity(f_.col(i).data()));
    return abs(h_) * most;
}

void ProjectedGauss::place_step(const Real* slopes) {
    half_.setZero();
    for (Eigen::Index i = 0; i < stages_; ++i) half_ += h_ / 2 * coefficients_.b[i] * k(slopes, i);
    system_.group().append_exp(start_.data(), half_.data(), middle_.data());
    u_ = 2 * half_;
    system_.group().append_exp(start_.data(), u_.data(), free_.data());
}

/// k - dexp^{-1}(V) and w - h f.
Status ProjectedGauss::step_residual(const Real* slopes, Real* r) {
    for (Eigen::Index i = 0; i < stages_; ++i) {
        const Status status = stage_residual(i, slopes, r);
        if (status != Status::ok && status != Status::turn_lost) return status;
    }
    return Status::ok;
}

void ProjectedGauss::place_stage(Eigen::Index i, const Real* slopes) {
    u_ = -half_, stage_v_ = moved_;
    for (Eigen::Index j = 0; j < stages_; ++j) {
        u_ += h_ * coefficients_.a(i, j) * k(slopes, j);
        stage_v_ += coefficients_.a(i, j) * w(slopes, j);
    }
}

Status ProjectedGauss::stage_residual(Eigen::Index i, const Real* slopes, Real* r) {
    place_stage(i, slopes);
    system_.group().append_exp(middle_.data(), u_.data(), stage_q_.data());
    if (!system_.group().dexpinv_left(u_.data(), stage_v_.data(), u_.data())) return Status::left_chart;
    Eigen::Map<VecX>(r + i * n_, n_) = k(slopes, i) - u_;
    const Status status =
        system_.evaluate(t_ + coefficients_.c[i] * h_, stage_q_.data(), stage_v_.data(), f_.col(i).data());
    Eigen::Map<VecX>(r + (stages_ + i) * n_, n_) = w(slopes, i) - h_ * f_.col(i);
    return status;
}

void ProjectedGauss::add_change(const Real* slopes, const Real& sign, VecX& to) const {
    for (Eigen::Index i = 0; i < stages_; ++i) to += sign * coefficients_.b[i] * w(slopes, i);
}

/// theta / h.
void ProjectedGauss::add_increment(const Real* slopes, const Real& sign, VecX& to) const {
    for (Eigen::Index i = 0; i < stages_; ++i) to += sign * coefficients_.b[i] * k(slopes, i);
}

/// k' of v~' in place of v~, but for its brackets.
void ProjectedGauss::follow(const VecX& shift, Real* r) const {
    for (Eigen::Index i = 0; i < stages_; ++i) Eigen::Map<VecX>(r + i * n_, n_) += shift;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
