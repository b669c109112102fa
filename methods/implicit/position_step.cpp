// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/position_step.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

PositionStep::PositionStep(System& system)
    : StepRelations(system.velocities()),
      system_(system),
      n_(system.velocities()),
      m_(system.constraints()),
      positions_(system.position_constraints()),
      scale_(system),
      weights_of_positions_(system, scale_),
      newton_(n_),
      past_(n_),
      x_(VecX::Zero(n_)),
      turned_(x_),
      weights_(VecX::Ones(n_)),
      rate_(x_),
      velocity_(x_),
      increment_(x_),
      force_(x_),
      gyroscopic_(x_),
      rows_(VecX::Zero(m_)),
      phi_(rows_),
      impulse_(rows_),
      lambda_(rows_),
      configuration_(static_cast<std::size_t>(system.group().size())) {}

Status PositionStep::start(const Real& t, const Real& h, const Real* y) {
    newton_.forget(), scale_.forget(), past_.clear();
    q_ = y;
    const Status status = system_.accelerations(t, y, system_.v(y), x_.data(), nullptr);
    if (status != Status::ok) return status;
    x_ *= h;
    scale_.weigh(y);
    remember();
    return weights_of_positions_.start(t, y);
}

Status PositionStep::advance(const Real& t, const Real& h, Real* y) {
    t_ = t, end_ = t + h, h_ = h, q_ = y;
    scale_.weigh(y);
    speed_ = scale_.of_velocity(system_.v(y));
    guess();
    if (const Status status = iterate(); status != Status::ok) {
        const Status cause = status == Status::newton_failed ? find_cause() : status;
        std::copy_n(q_, configuration_.size(), configuration_.begin());  // where the multipliers act
        end_ = t;
        return cause;
    }
    settle();
    accept(y);
    return Status::ok;
}

void PositionStep::guess() { past_.guess(newton_.stiff() ? 0 : past_.best_degree(n_), turned_); }

/// From the guess, and where that leads nowhere from unchanged velocities: springs that are stiff make accelerations
/// swing.
Status PositionStep::iterate() {
    const Status status = newton_.solve(*this, weights_, turned_.data());
    if (status != Status::newton_failed) return status;
    turned_.setZero();
    return newton_.solve(*this, weights_, turned_.data());
}

/// An iteration fails near poses in which rows lose rank. If the guess is such a pose, the system names the joints.
Status PositionStep::find_cause() {
    guess();
    scale_.from_space(q_, turned_.data(), x_.data());
    place();
    const Status status = system_.prepare_kkt(end_, configuration_.data());
    return status == Status::singular_kkt ? status : Status::newton_failed;
}

/// The iteration ends where x is known to the round-off of places over h, which as an error of every step along motions
/// that the joints allow would add up to eps |q| / h^2. The last solve knows x' along them h times better, but where
/// something is stiff it has the round-off of large forces.
void PositionStep::settle() {
    constexpr int most = 64;
    force_ = x_ - rate_;
    if (scale_.of_velocity(force_.data()) > most * round_off() * size_) return;
    x_ = rate_;
    place();
}

void PositionStep::place() {
    velocity_ = velocity_slope * x_ + velocity_offset;
    increment_ = increment_slope * x_ + increment_offset;
    force_ = h_ * increment_;
    system_.group().append_exp(q_, force_.data(), configuration_.data());
}

/// x - x' at a guess.
Status PositionStep::residual(const Real* turned, Real* r) {
    system_.count_evaluation();
    scale_.from_space(q_, turned, x_.data());
    place();
    evaluate_forces();
    size_ = max(max(speed_, scale_.of_impulse(force_.data())),
                Real(weights_of_positions_.reach() / abs(h_ * increment_slope)));
    set_rows();
    const Real* q = configuration_.data();
    if (const Status status = system_.prepare_kkt(end_, q); status != Status::ok) return status;
    const Status status = system_.solve_prepared(end_, q, force_.data(), rows_.data(), rate_.data(), impulse_.data());
    if (status != Status::ok) return status;
    force_ = x_ - rate_;
    scale_.to_space(q_, force_.data(), r);
    return Status::ok;
}

/// h Q at q+, v+.
void PositionStep::evaluate_forces() {
    const Real *q = configuration_.data(), *v = velocity_.data();
    system_.applied_force(end_, q, v, force_.data());
    system_.gyroscopic_force(q, v, gyroscopic_.data());
    force_ = h_ * (force_ + gyroscopic_);
}

/// C+ x - Phi / (h b), and -(b+ + C+ v^) / a of the rows without a position level.
void PositionStep::set_rows() {
    if (m_ == 0) return;
    const Real* q = configuration_.data();
    system_.apply_jacobian(end_, q, x_.data(), rows_.data());
    system_.position_residual(end_, q, phi_.data());
    rows_.head(positions_) -= phi_.head(positions_) / (h_ * increment_slope);
    if (m_ == positions_) return;
    system_.velocity_residual(end_, q, velocity_offset.data(), phi_.data());
    rows_.tail(m_ - positions_) = phi_.tail(m_ - positions_) / -velocity_slope;
}

void PositionStep::remember() {
    scale_.to_space(q_, x_.data(), turned_.data());
    past_.push(turned_);
}

void PositionStep::accept(Real* y) {
    lambda_ = impulse_ / h_;
    least_norm_ = false;
    remember();
    std::copy(configuration_.begin(), configuration_.end(), y);
    std::copy_n(velocity_.data(), n_, system_.v(y));
}

const Real* PositionStep::multipliers() const {
    if (!least_norm_) system_.minimise_multipliers(end_, configuration_.data(), lambda_.data());
    least_norm_ = true;
    return lambda_.data();
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
