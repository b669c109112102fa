// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/stabilised_step.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

StabilisedStep::StabilisedStep(System& system)
    : StepRelations(system.velocities()),
      system_(system),
      end_(system, *this),
      n_(system.velocities()),
      etas_(end_.etas()),
      scale_(system),
      weights_of_positions_(system, scale_),
      newton_(n_ + etas_),
      past_(n_ + etas_),
      unknowns_(VecX::Zero(n_ + etas_)),
      turned_(unknowns_),
      weights_(VecX::Ones(n_ + etas_)),
      difference_(VecX::Zero(n_)),
      lambda_(VecX::Zero(system.constraints())) {}

Status StabilisedStep::start(const Real& t, const Real& h, const Real* y) {
    newton_.forget(), scale_.forget(), past_.clear();
    h_ = h, q_ = y;
    if (const Status status = system_.accelerations(t, y, system_.v(y), end_.rate.data(), nullptr);
        status != Status::ok)
        return status;
    end_.rate *= h;
    scale_.weigh(y);
    size_ = scale_.of_motion(t, h, y);
    unknowns_.setZero();
    remember();
    return weights_of_positions_.start(t, y);
}

Status StabilisedStep::advance(const Real& t, const Real& h, Real* y) {
    h_ = h, q_ = y;
    end_.begin(t, h, y);
    scale_.weigh(y);
    speed_ = scale_.of_velocity(system_.v(y));
    if (weights_of_positions_.refresh(t, y)) newton_.forget();
    weigh_unknowns();
    guess();
    if (const Status status = iterate(); status != Status::ok) {
        const Status cause = status == Status::newton_failed ? find_cause() : status;
        end_.withdraw();  // where the multipliers act
        return cause;
    }
    if (const Status status = settle_positions(); status != Status::ok) return status;
    if (const Status status = settle_rate(); status != Status::ok) return status;
    accept(y);
    return Status::ok;
}

/// What the iteration has learnt holds for its weights.
void StabilisedStep::weigh_unknowns() {
    if (weights_of_positions_.rebalance(max(size_, speed_), h_)) newton_.forget();
    if (etas_ > 0) weights_.tail(etas_) = weights_of_positions_.weights();
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

void StabilisedStep::take(const Real* turned) {
    scale_.from_space(q_, turned, unknowns_.data());
    std::copy_n(turned + n_, etas_, unknowns_.data() + n_);
}

/// x - x' and eta - eta' at a guess.
Status StabilisedStep::residual(const Real* turned, Real* r) {
    system_.count_evaluation();
    take(turned);
    end_.place(unknowns_.data());
    const Real forced = scale_.of_impulse(end_.evaluate_forces().data());
    size_ = max(max(speed_, forced), weights_of_positions_.of_places(h_));
    if (const Status status = end_.solve_dynamics(); status != Status::ok) return status;
    difference_ = unknowns_.head(n_) - end_.rate;
    scale_.to_space(q_, difference_.data(), r);
    return etas_ > 0 ? end_.correct_positions(unknowns_.data(), r + n_) : Status::ok;
}

/// An iteration fails near poses in which rows lose rank. If the guess is such a pose, the system names the joints.
Status StabilisedStep::find_cause() {
    guess();
    take(turned_.data());
    end_.place(unknowns_.data());
    return end_.prepare() == Status::singular_kkt ? Status::singular_kkt : Status::newton_failed;
}

/// Where something is stiff, its round-off in x' reaches eta: then Phi = 0 is met for the last x, as far as corrections
/// lead nearer. Beside poses in which rows lose rank they do not.
Status StabilisedStep::settle_positions() {
    constexpr int most_corrections = 4;
    if (etas_ == 0 || !moves_positions()) return Status::ok;
    end_.rate = unknowns_.head(n_);  // x' = x
    Real defect = position_defect();
    for (int i = 0; i < most_corrections && moves_positions(); ++i) {
        VecX& change = end_.change;
        change.setZero();
        if (const Status status = end_.correct_positions(unknowns_.data(), change.data()); status != Status::ok)
            return status;
        unknowns_.tail(etas_) -= change;
        end_.place(unknowns_.data());
        const Real now = position_defect();
        if (!(now < defect)) {
            unknowns_.tail(etas_) += change;
            end_.place(unknowns_.data());
            break;
        }
        defect = now;
    }
    return end_.prepare();
}

/// The last guess satisfies Phi = 0, and x' of its solve C v + b = 0 at the same configuration; that solve is repeated
/// if it loses digits. In stiff systems x' has the round-off of large forces, and x is more accurate.
Status StabilisedStep::settle_rate() {
    difference_ = unknowns_.head(n_) - end_.rate;
    const bool stiff = scale_.of_velocity(difference_.data()) > 64 * round_off() * size_;
    if (stiff) end_.rate = unknowns_.head(n_);
    const bool digits_lost = stiff || system_.kkt_round_off() > 64 * epsilon;
    return system_.constraints() > 0 && digits_lost ? end_.correct_rate() : Status::ok;
}

void StabilisedStep::remember() {
    turned_.tail(etas_) = unknowns_.tail(etas_);
    scale_.to_space(q_, end_.rate.data(), turned_.data());
    past_.push(turned_);
}

void StabilisedStep::accept(Real* y) {
    lambda_ = end_.impulse() / h_;
    least_norm_ = false;
    remember();
    const VecX& velocity = end_.velocity_of_rate();
    std::copy(end_.configuration().begin(), end_.configuration().end(), y);
    std::copy_n(velocity.data(), n_, system_.v(y));
}

const Real* StabilisedStep::multipliers() const {
    if (!least_norm_) system_.minimise_multipliers(end_.time(), end_.configuration().data(), lambda_.data());
    least_norm_ = true;
    return lambda_.data();
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
