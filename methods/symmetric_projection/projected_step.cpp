// SPDX-License-Identifier: BSD-3-Clause
#include "methods/symmetric_projection/projected_step.hpp"

#include <algorithm>
#include <limits>

namespace kreisel {
inline namespace KREISEL_PRECISION {

ProjectedStep::ProjectedStep(System& system, const MotionScale& scale, Eigen::Index slopes)
    : system_(system),
      scale_(scale),
      n_(system.velocities()),
      m_(system.constraints()),
      start_(static_cast<std::size_t>(system.group().size())),
      middle_(start_),
      free_(start_),
      moved_(VecX::Zero(n_)),
      u_(moved_),
      slopes_(slopes),
      configuration_(start_),
      v_(moved_),
      shift_(moved_),
      velocity_(moved_),
      zero_(moved_),
      rows_(VecX::Zero(m_)),
      phi_(rows_) {}

void ProjectedStep::begin(const Real& t, const Real& h, const Real* q, const Real* v) {
    t_ = t, end_ = t + h, h_ = h, q_ = q;
    v_ = Eigen::Map<const VecX>(v, n_);
}

void ProjectedStep::pull_back(const Real& t, const Real* q, const Real* multipliers) {
    system_.apply_jacobian_transpose(t, q, multipliers, u_.data());
    system_.solve_mass(q, u_.data(), shift_.data());
}

void ProjectedStep::place(const Real* x) {
    const Real *mu = x + slopes_ * n_, *nu = mu + m_;
    std::copy_n(q_, start_.size(), start_.begin());
    moved_ = v_;
    if (m_ > 0) {
        pull_back(t_, q_, nu);
        moved_ += shift_;
        pull_back(t_, q_, mu);
        u_ = h_ * shift_;
        system_.group().append_exp(start_.data(), u_.data(), start_.data());
    }
    place_step(x);
    place_end(mu);
}

/// q+ = q~+ exp(h G(q+) mu), a contraction by the small h G mu, down to round-off.
void ProjectedStep::place_end(const Real* mu) {
    constexpr int most = 40;
    configuration_ = free_;
    if (m_ == 0) return;
    Real before = std::numeric_limits<Real>::max();
    velocity_.setZero();
    for (int i = 0; i < most; ++i) {
        pull_back(end_, configuration_.data(), mu);
        velocity_ -= shift_;
        const Real now = scale_.of_velocity(velocity_.data());
        velocity_ = shift_;
        u_ = h_ * shift_;
        system_.group().append_exp(free_.data(), u_.data(), configuration_.data());
        if (!(now > 0) || !(2 * now < before)) return;
        before = now;
    }
}

Status ProjectedStep::residual(const Real* x, Real* r) {
    place(x);
    const Status status = step_residual(x, r);
    if (status != Status::ok && status != Status::turn_lost) return status;
    return correct(x, r);
}

Status ProjectedStep::correction(const Real* x, Real* r) {
    Eigen::Map<VecX>(r, slopes_ * n_).setZero();
    return correct(x, r);
}

/// With v+' and D', of slopes' in place of slopes, D the increment over h: 2 S (nu' - nu) + C+ v+' + b+ = 0, and
/// 2 S (mu' - mu) + Phi / h + C+ (D' - D) + S (nu' - nu) = 0, S = C M^{-1} C^T of the middle, for the mean of
/// C+ M^{-1} C^T of both ends. S of q+ is too small where a step leads towards a pose in which rows lose rank, and the
/// multipliers overshoot.
Status ProjectedStep::correct(const Real* x, Real* r) {
    if (m_ == 0) return Status::ok;
    const Real time = t_ + h_ / 2, *q = configuration_.data(), *middle = middle_.data();
    Eigen::Map<VecX> of_mu(r + slopes_ * n_, m_), of_nu(r + slopes_ * n_ + m_, m_);
    velocity(x);
    add_change(r, -1, velocity_);
    system_.velocity_residual(end_, q, velocity_.data(), rows_.data());
    if (const Status status = system_.prepare_kkt(time, middle); status != Status::ok) return status;
    const Status first = system_.solve_prepared(time, middle, zero_.data(), rows_.data(), shift_.data(), of_nu.data());
    if (first != Status::ok) return first;
    of_nu /= -2;
    u_.setZero();
    add_increment(r, -1, u_);
    system_.apply_jacobian(end_, q, u_.data(), phi_.data());
    rows_ = phi_ - rows_ / 2;
    system_.position_residual(end_, q, phi_.data());
    rows_ += phi_ / h_;
    const Status status = system_.solve_prepared(time, middle, zero_.data(), rows_.data(), shift_.data(), of_mu.data());
    of_mu /= -2;
    pull_back(t_, q_, of_nu.data());
    follow(shift_, r);
    return status;
}

const VecX& ProjectedStep::velocity(const Real* x) {
    velocity_ = moved_;
    add_change(x, 1, velocity_);
    if (m_ == 0) return velocity_;
    pull_back(end_, configuration_.data(), x + slopes_ * n_ + m_);
    return velocity_ += shift_;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
