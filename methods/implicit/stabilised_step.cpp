// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/stabilised_step.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

StabilisedStep::StabilisedStep(System& system)
    : velocity_slope(0),
      increment_slope(0),
      velocity_offset(VecX::Zero(system.velocities())),
      increment_offset(velocity_offset),
      system_(system),
      n_(system.velocities()),
      m_(system.constraints()),
      positions_(system.position_constraints()),
      scale_(system),
      etas_count_(positions_ > 0 ? m_ : 0),
      newton_(n_ + etas_count_),
      rates_(n_),
      etas_(m_),
      unknowns_(VecX::Zero(n_ + etas_count_)),
      weights_(unknowns_),
      increment_(velocity_offset),
      velocity_(velocity_offset),
      rate_(velocity_offset),
      force_(velocity_offset),
      gyroscopic_(velocity_offset),
      shift_(velocity_offset),
      shift_force_(velocity_offset),
      rows_(VecX::Zero(m_)),
      eta_(rows_),
      row_weights_(rows_),
      change_(rows_),
      impulse_(rows_),
      lambda_(rows_),
      configuration_(static_cast<std::size_t>(system.group().size())) {}

Status StabilisedStep::start(const Real& t, const Real& h, const Real* y) {
    newton_.forget(), scale_.forget(), rates_.clear(), etas_.clear();
    balance_ = 0, h_ = h, start_ = t, q_ = y;
    const Real* v = y + configuration_.size();
    if (const Status status = system_.accelerations(t, y, v, rate_.data(), nullptr); status != Status::ok)
        return status;
    rate_ *= h;
    eta_.setZero();
    rates_.push(rate_), etas_.push(eta_);
    scale_.weigh(y);
    size_ = scale_.of_motion(t, h, y);
    return measure_positions(t, y);
}

/// The largest velocity times h that repairs rows off by the size of their terms.
Status StabilisedStep::measure_positions(const Real& t, const Real* q) {
    reach_ = 0, remoteness_ = 1;
    if (positions_ == 0) return Status::ok;
    system_.complement_diagonal(t, q, row_weights_.data());
    const Real unit = scale_.mass_unit();
    for (Real& weight : row_weights_) weight = sqrt(weight * unit) / unit;
    rows_.setZero();
    system_.position_scale(q, rows_.data());
    system_.row_scale(impulse_.data());
    remoteness_ = max(remoteness_, Real(rows_.head(positions_).cwiseQuotient(impulse_.head(positions_)).maxCoeff()));
    force_.setZero();
    if (const Status status = system_.prepare_kkt(t, q); status != Status::ok) return status;
    const Status status = system_.solve_prepared(t, q, force_.data(), rows_.data(), shift_.data(), nullptr);
    reach_ = scale_.of_velocity(shift_.data());
    return status;
}

Status StabilisedStep::advance(const Real& t, const Real& h, Real* y) {
    h_ = h, start_ = t, end_ = t + h, q_ = y;
    scale_.weigh(y);
    speed_ = scale_.of_velocity(y + configuration_.size());
    balance();
    guess();
    if (const Status status = newton_.solve(*this, weights_, unknowns_.data()); status != Status::ok) {
        const Status cause = status == Status::newton_failed ? find_cause() : status;
        std::copy_n(y, configuration_.size(), configuration_.begin());  // where the multipliers belong
        end_ = t;
        return cause;
    }
    if (const Status status = settle_positions(); status != Status::ok) return status;
    if (const Status status = settle_rate(); status != Status::ok) return status;
    velocity_ = velocity_slope * rate_ + velocity_offset;
    lambda_ = impulse_ / h;
    least_norm_ = false;
    rates_.push(rate_);
    if (etas_count_ > 0) etas_.push(eta_ = unknowns_.tail(m_));
    std::copy(configuration_.begin(), configuration_.end(), y);
    std::copy_n(velocity_.data(), n_, y + configuration_.size());
    return Status::ok;
}

/// An iteration fails beside poses in which rows lose rank. Where the guess is one, the system names the joints.
Status StabilisedStep::find_cause() {
    guess();
    place(unknowns_.data());
    return system_.prepare_kkt(end_, configuration_.data()) == Status::singular_kkt ? Status::singular_kkt
                                                                                    : Status::newton_failed;
}

/// Where something is stiff, its round-off in x' reaches eta: then Phi = 0 is met for the last x.
Status StabilisedStep::settle_positions() {
    constexpr int most_corrections = 4;
    bool moved = false;
    for (int i = 0; i < most_corrections && etas_count_ > 0; ++i) {
        if (!(row_weights_.cwiseProduct(change_).cwiseAbs().maxCoeff() * balance_ > 64 * epsilon * size_)) break;
        moved = true;
        rate_ = unknowns_.head(n_);  // x' = x
        change_.setZero();
        if (const Status status = correct_positions(unknowns_.data(), change_.data()); status != Status::ok)
            return status;
        unknowns_.tail(m_) -= change_;
        place(unknowns_.data());
    }
    return moved ? system_.prepare_kkt(end_, configuration_.data()) : Status::ok;
}

/// The last guess fulfils Phi = 0, and x' of its solve C v + b = 0 at the same configuration, which is solved for once more
/// where the solve loses digits. Where something is stiff, x' has the round-off of large forces: then x is known better.
Status StabilisedStep::settle_rate() {
    shift_ = unknowns_.head(n_) - rate_;
    const bool stiff = scale_.of_velocity(shift_.data()) > 64 * round_off() * size_;
    if (stiff) rate_ = unknowns_.head(n_);
    if (m_ == 0 || !(stiff || system_.kkt_round_off() > 64 * epsilon)) return Status::ok;
    velocity_ = velocity_slope * rate_ + velocity_offset;
    system_.velocity_residual(end_, configuration_.data(), velocity_.data(), rows_.data());
    rows_ /= -velocity_slope;
    force_.setZero();
    const Status status =
        system_.solve_prepared(end_, configuration_.data(), force_.data(), rows_.data(), shift_.data(), nullptr);
    rate_ += shift_;
    return status;
}

/// Weights of e follow the ratio of motion and place in large steps, so that what the iteration has learnt stays valid.
void StabilisedStep::balance() {
    constexpr int much = 1024;
    const Real size = max(size_, speed_), place = reach_ / abs(h_), least = epsilon;
    const Real now = size < place ? max(Real(size / place), least) : Real(1);
    if (now > much * balance_ || balance_ > much * now) {
        balance_ = now;
        newton_.forget();
    }
    weights_.head(n_) = scale_.weights();
    if (etas_count_ > 0) weights_.tail(m_) = balance_ * row_weights_;
}

void StabilisedStep::guess() {
    const int degree = newton_.stiff() ? 0 : rates_.best_degree(scale_.weights());
    rates_.guess(degree, rate_);
    unknowns_.head(n_) = rate_;
    if (etas_count_ == 0) return;
    etas_.guess(degree, eta_);
    unknowns_.tail(m_) = eta_;
}

/// M^{-1} C(q)^T eta.
void StabilisedStep::pull_back(const Real* eta) {
    system_.apply_jacobian_transpose(start_, q_, eta, shift_force_.data());
    system_.solve_mass(q_, shift_force_.data(), shift_.data());
}

void StabilisedStep::place(const Real* x) {
    const Eigen::Map<const VecX> rate(x, n_);
    velocity_ = velocity_slope * rate + velocity_offset;
    increment_ = increment_slope * rate + increment_offset;
    if (etas_count_ > 0) {
        pull_back(x + n_);
        increment_ -= shift_;
    }
    force_ = h_ * increment_;
    system_.group().append_exp(q_, force_.data(), configuration_.data());
}

Status StabilisedStep::residual(const Real* x, Real* r) {
    system_.count_evaluation();
    place(x);
    if (const Status status = solve_dynamics(); status != Status::ok) return status;
    Eigen::Map<VecX>(r, n_) = Eigen::Map<const VecX>(x, n_) - rate_;
    return etas_count_ > 0 ? correct_positions(x, r + n_) : Status::ok;
}

/// h v'+ and h lambda at the guess.
Status StabilisedStep::solve_dynamics() {
    const Real *q = configuration_.data(), *v = velocity_.data();
    system_.applied_force(end_, q, v, force_.data());
    system_.gyroscopic_force(q, v, gyroscopic_.data());
    force_ = h_ * (force_ + gyroscopic_);
    size_ = max(max(speed_, scale_.of_impulse(force_.data())), Real(balance_ * reach_ / abs(h_)));
    if (m_ > 0) {
        system_.velocity_residual(end_, q, velocity_offset.data(), rows_.data());
        rows_ /= -velocity_slope;
    }
    if (const Status status = system_.prepare_kkt(end_, q); status != Status::ok) return status;
    return system_.solve_prepared(end_, q, force_.data(), rows_.data(), rate_.data(), impulse_.data());
}

/// eta - eta' at the guess x.
Status StabilisedStep::correct_positions(const Real* x, Real* change) {
    const Real* q = configuration_.data();
    Eigen::Map<VecX> difference(change, m_);
    force_ = increment_slope * (rate_ - Eigen::Map<const VecX>(x, n_));
    system_.apply_jacobian(end_, q, force_.data(), rows_.data());
    system_.position_residual(end_, q, change);
    rows_.head(positions_) += difference.head(positions_) / h_;
    if (m_ > positions_) {
        force_ = increment_ - increment_offset - increment_slope * Eigen::Map<const VecX>(x, n_);  // - M^{-1} C^T eta
        system_.apply_jacobian(end_, q, force_.data(), change);
        rows_.tail(m_ - positions_) = difference.tail(m_ - positions_);
    }
    force_.setZero();
    const Status status = system_.solve_prepared(end_, q, force_.data(), rows_.data(), shift_.data(), change);
    change_ = difference;
    return status;
}

const Real* StabilisedStep::multipliers() const {
    if (!least_norm_) system_.minimise_multipliers(end_, configuration_.data(), lambda_.data());
    least_norm_ = true;
    return lambda_.data();
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
