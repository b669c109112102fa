// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/position_weights.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

PositionWeights::PositionWeights(System& system, const MotionScale& scale)
    : system_(system),
      scale_(scale),
      m_(system.constraints()),
      positions_(system.position_constraints()),
      row_weights_(VecX::Zero(m_)),
      lengths_(row_weights_),
      rows_(row_weights_),
      zero_(VecX::Zero(system.velocities())),
      shift_(zero_) {}

Status PositionWeights::start(const Real& t, const Real* q) {
    balance_ = 0, steps_ = 0, reach_ = 0, remoteness_ = 1;
    if (positions_ == 0) return Status::ok;
    weigh_rows(t, q, row_weights_);
    rows_.setZero();
    system_.position_scale(q, rows_.data());
    system_.row_scale(lengths_.data());
    remoteness_ = max(remoteness_, Real(rows_.head(positions_).cwiseQuotient(lengths_.head(positions_)).maxCoeff()));
    if (const Status status = system_.prepare_kkt(t, q); status != Status::ok) return status;
    const Status status = system_.solve_prepared(t, q, zero_.data(), rows_.data(), shift_.data(), nullptr);
    reach_ = scale_.of_velocity(shift_.data());
    return status;
}

void PositionWeights::weigh_rows(const Real& t, const Real* q, VecX& weights) const {
    system_.complement_diagonal(t, q, weights.data());
    const Real unit = scale_.mass_unit();
    for (Real& weight : weights) weight = sqrt(weight * unit) / unit;
}

bool PositionWeights::refresh(const Real& t, const Real* q) {
    constexpr int now_and_then = 8, much = 2;
    if (positions_ == 0 || ++steps_ % now_and_then != 0) return false;
    weigh_rows(t, q, rows_);
    bool changed = false;
    for (Eigen::Index i = 0; i < m_; ++i)
        changed |= rows_[i] > much * row_weights_[i] || row_weights_[i] > much * rows_[i];
    if (changed) row_weights_ = rows_;
    return changed;
}

bool PositionWeights::rebalance(const Real& motion, const Real& h) {
    constexpr int much = 1024;
    const Real places = reach_ / abs(h), least = epsilon;
    const Real now = motion < places ? max(Real(motion / places), least) : Real(1);
    if (!(now > much * balance_ || balance_ > much * now)) return false;
    balance_ = now;
    return true;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
