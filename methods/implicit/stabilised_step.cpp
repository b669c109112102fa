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
      weights_of_positions_(system, scale_),
      etas_count_(positions_ > 0 ? m_ : 0),
      newton_(n_ + etas_count_),
      past_(n_ + etas_count_),
      unknowns_(VecX::Zero(n_ + etas_count_)),
      turned_(unknowns_),
      weights_(VecX::Ones(n_ + etas_count_)),
      increment_(velocity_offset),
      velocity_(velocity_offset),
      rate_(velocity_offset),
      force_(velocity_offset),
      gyroscopic_(velocity_offset),
      shift_(velocity_offset),
      shift_force_(velocity_offset),
      rows_(VecX::Zero(m_)),
      change_(rows_),
      impulse_(rows_),
      lambda_(rows_),
      configuration_(static_cast<std::size_t>(system.group().size())) {}

Status StabilisedStep::start(const Real& t, const Real& h, const Real* y) {
    newton_.forget(), scale_.forget(), past_.clear();
    h_ = h, start_ = t, q_ = y;
    if (const Status status = system_.accelerations(t, y, system_.v(y), rate_.data(), nullptr); status != Status::ok)
        return status;
    rate_ *= h;
    scale_.weigh(y);
    size_ = scale_.of_motion(t, h, y);
    unknowns_.setZero();
    remember();
    return weights_of_positions_.start(t, y);
}

Status StabilisedStep::advance(const Real& t, const Real& h, Real* y) {
    h_ = h, start_ = t, end_ = t + h, q_ = y;
    scale_.weigh(y);
    speed_ = scale_.of_velocity(system_.v(y));
    weigh_unknowns();
    guess();
    if (const Status status = iterate(); status != Status::ok) {
        const Status cause = status == Status::newton_failed ? find_cause() : status;
        std::copy_n(y, configuration_.size(), configuration_.begin());  // where the multipliers act
        end_ = t;
        return cause;
    }
    if (const Status status = settle_positions(); status != Status::ok) return status;
    if (const Status status = settle_rate(); status != Status::ok) return status;
    accept(y);
    return Status::ok;
}

/// What the iteration has learnt holds for its weights.
void StabilisedStep::weigh_unknowns() {
    if (weights_of_positions_.refresh(start_, q_)) newton_.forget();
    if (weights_of_positions_.rebalance(max(size_, speed_), h_)) newton_.forget();
    if (etas_count_ > 0) weights_.tail(m_) = weights_of_positions_.weights();
}

void StabilisedStep::guess() { past_.guess(newton_.stiff() ? 0 : past_.best_degree(n_), turned_); }

/// From the guess, and where that leads nowhere from unchanged velocities: springs that are stiff make accelerations
/// swing.
Status StabilisedStep::iterate() {
    const Status status = newton_.solve(*this, weights_, turned_.data());
    if (status != Status::newton_failed) return status;
    turned_.setZero();
    return newton_.solve(*this, weights_, turned_.data());
}

void StabilisedStep::accept(Real* y) {
    velocity_ = velocity_slope * rate_ + velocity_offset;
    lambda_ = impulse_ / h_;
    least_norm_ = false;
    remember();
    std::copy(configuration_.begin(), configuration_.end(), y);
    std::copy_n(velocity_.data(), n_, system_.v(y));
}

/// An iteration fails near poses in which rows lose rank. If the guess is such a pose, the system names the joints.
Status StabilisedStep::find_cause() {
    guess();
    take(turned_.data());
    place(unknowns_.data());
    return system_.prepare_kkt(end_, configuration_.data()) == Status::singular_kkt ? Status::singular_kkt
                                                                                    : Status::newton_failed;
}

/// Where something is stiff, its round-off in x' reaches eta: then Phi = 0 is met for the last x, as far as corrections
/// lead nearer. Beside poses in which rows lose rank they do not.
Status StabilisedStep::settle_positions() {
    constexpr int most_corrections = 4;
    if (etas_count_ == 0 || !moves_positions()) return Status::ok;
    rate_ = unknowns_.head(n_);  // x' = x
    Real defect = position_defect();
    for (int i = 0; i < most_corrections && moves_positions(); ++i) {
        change_.setZero();
        if (const Status status = correct_positions(unknowns_.data(), change_.data()); status != Status::ok)
            return status;
        unknowns_.tail(m_) -= change_;
        place(unknowns_.data());
        const Real now = position_defect();
        if (!(now < defect)) {
            unknowns_.tail(m_) += change_;
            place(unknowns_.data());
            break;
        }
        defect = now;
    }
    return system_.prepare_kkt(end_, configuration_.data());
}

/// Largest entry of Phi at q+, each over the scale of its row.
Real StabilisedStep::position_defect() {
    system_.position_residual(end_, configuration_.data(), rows_.data());
    return weights_of_positions_.of_residual(rows_);
}

/// The last guess satisfies Phi = 0, and x' of its solve C v + b = 0 at the same configuration; that solve is repeated
/// if it loses digits. In stiff systems x' has the round-off of large forces, and x is more accurate.
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

void StabilisedStep::remember() {
    turned_.tail(etas_count_) = unknowns_.tail(etas_count_);
    scale_.to_space(q_, rate_.data(), turned_.data());
    past_.push(turned_);
}

void StabilisedStep::take(const Real* turned) {
    scale_.from_space(q_, turned, unknowns_.data());
    std::copy_n(turned + n_, etas_count_, unknowns_.data() + n_);
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

Status StabilisedStep::residual(const Real* turned, Real* r) {
    system_.count_evaluation();
    take(turned);
    place(unknowns_.data());
    if (const Status status = solve_dynamics(); status != Status::ok) return status;
    force_ = unknowns_.head(n_) - rate_;
    scale_.to_space(q_, force_.data(), r);
    return etas_count_ > 0 ? correct_positions(unknowns_.data(), r + n_) : Status::ok;
}

/// h v'+ and h lambda at the guess.
Status StabilisedStep::solve_dynamics() {
    const Real *q = configuration_.data(), *v = velocity_.data();
    system_.applied_force(end_, q, v, force_.data());
    system_.gyroscopic_force(q, v, gyroscopic_.data());
    force_ = h_ * (force_ + gyroscopic_);
    size_ = max(max(speed_, scale_.of_impulse(force_.data())), weights_of_positions_.of_places(h_));
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
