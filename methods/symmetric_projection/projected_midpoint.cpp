// SPDX-License-Identifier: BSD-3-Clause
#include "methods/symmetric_projection/projected_midpoint.hpp"

#include <algorithm>
#include <limits>

namespace kreisel {
inline namespace KREISEL_PRECISION {

ProjectedMidpoint::ProjectedMidpoint(System& system, const MotionScale& scale)
    : system_(system),
      scale_(scale),
      n_(system.velocities()),
      m_(system.constraints()),
      start_(static_cast<std::size_t>(system.group().size())),
      middle_(start_),
      free_(start_),
      configuration_(start_),
      v_(VecX::Zero(n_)),
      moved_(v_),
      middle_v_(v_),
      f_(v_),
      u_(v_),
      shift_(v_),
      velocity_(v_),
      zero_(v_),
      rows_(VecX::Zero(m_)),
      phi_(rows_) {}

void ProjectedMidpoint::begin(const Real& t, const Real& h, const Real* q, const Real* v) {
    t_ = t, end_ = t + h, h_ = h, q_ = q;
    v_ = Eigen::Map<const VecX>(v, n_);
}

void ProjectedMidpoint::pull_back(const Real& t, const Real* q, const Real* multipliers) {
    system_.apply_jacobian_transpose(t, q, multipliers, u_.data());
    system_.solve_mass(q, u_.data(), shift_.data());
}

void ProjectedMidpoint::place(const Real* x) {
    const Group& group = system_.group();
    std::copy_n(q_, start_.size(), start_.begin());
    moved_ = v_;
    if (m_ > 0) {
        pull_back(t_, q_, x + n_ + m_);
        moved_ += shift_;
        pull_back(t_, q_, x + n_);
        u_ = h_ * shift_;
        group.append_exp(start_.data(), u_.data(), start_.data());
    }
    middle_v_ = moved_ + Eigen::Map<const VecX>(x, n_) / 2;
    u_ = h_ / 2 * middle_v_;
    group.append_exp(start_.data(), u_.data(), middle_.data());
    u_ = h_ * middle_v_;
    group.append_exp(start_.data(), u_.data(), free_.data());
    place_end(x + n_);
}

/// q+ = q~+ exp(h G(q+) mu), a contraction by the small h G mu, down to round-off.
void ProjectedMidpoint::place_end(const Real* mu) {
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

Status ProjectedMidpoint::residual(const Real* x, Real* r) {
    place(x);
    // Iterates may turn farther than the final step: only the last one is checked, at the end of the step.
    const Status status = system_.evaluate(t_ + h_ / 2, middle_.data(), middle_v_.data(), f_.data());
    if (status != Status::ok && status != Status::turn_lost) return status;
    Eigen::Map<VecX>(r, n_) = Eigen::Map<const VecX>(x, n_) - h_ * f_;
    return correct(x, r);
}

Status ProjectedMidpoint::correction(const Real* x, Real* r) {
    Eigen::Map<VecX>(r, n_).setZero();
    return correct(x, r);
}

/// With w' = w - r: 2 S (nu' - nu) + C+ v+ + b+ = 0, and 2 S (mu' - mu) + Phi / h + C+ (w' - w) / 2 + S (nu' - nu) = 0,
/// S = C M^{-1} C^T of the middle, for the mean of C+ M^{-1} C^T of both ends. S of q+ is too small where a step leads
/// towards a pose in which rows lose rank, and the multipliers overshoot.
Status ProjectedMidpoint::correct(const Real* x, Real* r) {
    if (m_ == 0) return Status::ok;
    const Real time = t_ + h_ / 2, *q = configuration_.data(), *middle = middle_.data();
    const Eigen::Map<const VecX> of_w(r, n_);
    Eigen::Map<VecX> of_mu(r + n_, m_), of_nu(r + n_ + m_, m_);
    velocity(x);
    velocity_ -= of_w;
    system_.velocity_residual(end_, q, velocity_.data(), rows_.data());
    if (const Status status = system_.prepare_kkt(time, middle); status != Status::ok) return status;
    const Status first = system_.solve_prepared(time, middle, zero_.data(), rows_.data(), shift_.data(), of_nu.data());
    if (first != Status::ok) return first;
    of_nu /= -2;
    u_ = -of_w / 2;
    system_.apply_jacobian(end_, q, u_.data(), phi_.data());
    rows_ = phi_ - rows_ / 2;
    system_.position_residual(end_, q, phi_.data());
    rows_ += phi_ / h_;
    const Status status = system_.solve_prepared(time, middle, zero_.data(), rows_.data(), shift_.data(), of_mu.data());
    of_mu /= -2;
    return status;
}

const VecX& ProjectedMidpoint::velocity(const Real* x) {
    velocity_ = moved_ + Eigen::Map<const VecX>(x, n_);
    if (m_ == 0) return velocity_;
    pull_back(end_, configuration_.data(), x + n_ + m_);
    return velocity_ += shift_;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
