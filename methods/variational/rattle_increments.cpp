// SPDX-License-Identifier: BSD-3-Clause
#include "methods/variational/rattle_increments.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Places over h beside the motion, of steps so short that the iteration may not end at the round-off of the motion: it
/// knows D no better than to some thousand units.
constexpr int much = 16384;

}  // namespace

RattleIncrements::RattleIncrements(System& system, std::unique_ptr<RattleEquations> equations)
    : system_(system),
      equations_(std::move(equations)),
      n_(system.velocities()),
      m_(system.constraints()),
      scale_(system),
      rows_(system, scale_),
      newton_(n_ + m_),
      past_(n_ + m_),
      unknowns_(VecX::Zero(n_ + m_)),
      r_(unknowns_),
      turned_(unknowns_),
      weights_(VecX::Ones(n_ + m_)),
      applied_(VecX::Zero(n_)),
      gyroscopic_(applied_),
      lambda_(VecX::Zero(m_)),
      bias_(lambda_) {}

Status RattleIncrements::begin(const Real& t, const Real& h, const Real& span, const Real* y) {
    newton_.forget(), scale_.forget(), past_.clear();
    q_ = y;
    scale_.weigh(y);
    const Real* v = system_.v(y);
    if (const Status status = index_one(t, y, v); status != Status::ok) return status;
    unknowns_.head(n_) = Eigen::Map<const VecX>(v, n_) + h / 2 * unknowns_.head(n_);
    unknowns_.tail(m_) = span * lambda_;
    remember();
    return rows_.start(t, y);
}

/// v' in the unknowns, and some lambda: without the search for those of least norm, which allocates.
Status RattleIncrements::index_one(const Real& t, const Real* y, const Real* v) {
    if (m_ == 0) return system_.accelerations(t, y, v, unknowns_.data(), nullptr);
    if (const Status status = system_.prepare_kkt(t, y); status != Status::ok) return status;
    system_.count_evaluation();
    system_.applied_force(t, y, v, applied_.data());
    system_.gyroscopic_force(y, v, gyroscopic_.data());
    applied_ += gyroscopic_;
    system_.acceleration_bias(t, y, v, bias_.data());
    return system_.solve_prepared(t, y, applied_.data(), bias_.data(), unknowns_.data(), lambda_.data());
}

Status RattleIncrements::solve(const Real& t, const Real& h, const Real* y) {
    q_ = y;
    scale_.weigh(y);
    const Real motion = scale_.of_motion(t, h, y);
    if (!isfinite(motion)) return Status::non_finite;
    const Real places = rows_.reach() / abs(h), known = places > much * motion ? places : motion;
    if (rows_.refresh(t, y)) newton_.forget();
    if (rows_.rebalance(known, h)) newton_.forget();
    if (m_ > 0) weights_.tail(m_) = rows_.weights();
    equations_->begin(t, h, y, system_.v(y));
    size_ = max(known, rows_.of_places(h));
    const Status status = iterate(y);
    if (status == Status::ok && (size_ > much * motion || is_near())) equations_->settle(unknowns_.data(), r_.data());
    return status;
}

/// Whether what is left is round-off of the motion, and not of large forces, of which D' has more than D. Beside poses
/// in which rows lose rank D' has more, too.
bool RattleIncrements::is_near() const { return m_ == 0 && scale_.of_velocity(r_.data()) <= 64 * round_off() * size_; }

/// From the guess, and where that leads nowhere, or out of the chart, from an unchanged velocity.
Status RattleIncrements::iterate(const Real* y) {
    past_.guess(newton_.stiff() ? 0 : past_.best_degree(n_), turned_);
    const Status status = newton_.solve(*this, weights_, turned_.data());
    if (status != Status::newton_failed && status != Status::left_chart) return status;
    turned_.setZero();
    scale_.to_space(q_, system_.v(y), turned_.data());
    return newton_.solve(*this, weights_, turned_.data());
}

Status RattleIncrements::residual(const Real* turned, Real* r) {
    system_.count_evaluation();
    scale_.from_space(q_, turned, unknowns_.data());
    std::copy_n(turned + n_, m_, unknowns_.data() + n_);
    const Status status = equations_->residual(unknowns_.data(), r_.data());
    if (status != Status::ok) return status;
    std::copy_n(r_.data() + n_, m_, r + n_);
    scale_.to_space(q_, r_.data(), r);
    return status;
}

void RattleIncrements::remember() {
    turned_.tail(m_) = unknowns_.tail(m_);
    scale_.to_space(q_, unknowns_.data(), turned_.data());
    past_.push(turned_);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
