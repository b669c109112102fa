// SPDX-License-Identifier: BSD-3-Clause
//
// The unknown of the iteration is w = v+ - v, in space axes.
#include "methods/energy/energy_momentum.hpp"

#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/implicit/block_mass.hpp"
#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton/newton.hpp"
#include "methods/implicit/predictor.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class EnergyMomentum final : public Integrator, private Equations {
  public:
    EnergyMomentum(System& system, StepForce force)
        : system_(system),
          gradient_(force == StepForce::gradient && system.has_potential()),
          newton_(system.velocities()),
          scale_(system),
          mass_(system),
          changes_(system.velocities()),
          w_(VecX::Zero(system.velocities())),
          turned_(w_),
          weights_(VecX::Ones(w_.size())),
          V_(w_),
          half_u_(w_),
          p_(w_),
          pulled_(w_),
          f_(w_),
          next_w_(w_),
          half_turn_(static_cast<std::size_t>(system.group().size())),
          middle_q_(half_turn_),
          next_q_(half_turn_) {}

    Status start(const Real&, const Real*) override {
        known_h_ = 0;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.accelerations(t, y, system_.v(y), f_.data(), nullptr);
        if (h != known_h_) newton_.forget(), scale_.forget(), changes_.clear();
        known_h_ = 0;  // until this step has succeeded
        if (const Status status = begin(t, h, y); status != Status::ok) return status;
        const Status status = solve();
        work_.newton_iterations = newton_.iterations();
        if (status != Status::ok) return status;
        changes_.push(turned_);
        Eigen::Map<VecX>(system_.v(y), w_.size()) += next_w_;
        std::copy(next_q_.begin(), next_q_.end(), y);
        ++work_.exponentials;
        known_h_ = h;
        return Status::ok;
    }

  private:
    Status begin(const Real& t, const Real& h, const Real* y) {
        t_ = t, h_ = h, q_ = y, v_ = system_.v(y);
        scale_.weigh(y), mass_.weigh(y);
        mass_.multiply(v_, p_.data());
        motion_ = scale_.of_motion(t, h, y);
        if (!isfinite(motion_)) return Status::non_finite;
        if (gradient_) potential_ = system_.potential(t, y);
        if (!changes_.empty()) {
            changes_.guess(newton_.stiff() ? 0 : changes_.best_degree(w_.size()), turned_);
            return Status::ok;
        }
        const Status status = system_.accelerations(t, y, v_, w_.data(), nullptr);
        w_ *= h;
        scale_.to_space(y, w_.data(), turned_.data());
        return status;
    }

    /// From the guess, and where that leads nowhere from an unchanged velocity.
    Status solve() {
        const Status status = newton_.solve(*this, weights_, turned_.data());
        if (status != Status::newton_failed) return status;
        turned_.setZero();
        return newton_.solve(*this, weights_, turned_.data());
    }

    /// r = w - M^{-1} (p+ - p) for V = v + w/2.
    Status residual(const Real* turned, Real* r) override {
        system_.count_evaluation();
        scale_.from_space(q_, turned, w_.data());
        const Eigen::Map<const VecX> v(v_, w_.size());
        V_ = v + w_ / 2;
        half_u_ = h_ / 2 * V_;
        const Group& group = system_.group();
        group.append_exp(q_, half_u_.data(), middle_q_.data());
        group.append_exp(middle_q_.data(), half_u_.data(), next_q_.data());
        group.identity(half_turn_.data());
        group.append_exp(half_turn_.data(), half_u_.data(), half_turn_.data());
        find_force();
        group.coAd(half_turn_.data(), p_.data(), pulled_.data());
        pulled_ += h_ * f_;
        group.coAd(half_turn_.data(), pulled_.data(), pulled_.data());
        pulled_ -= p_;  // M^{-1} M v is v to round-off only, of the same sign at every step
        system_.solve_mass(q_, pulled_.data(), next_w_.data());
        pulled_ = w_ - next_w_;
        scale_.to_space(q_, pulled_.data(), r);
        return Status::ok;
    }

    /// The difference of two potentials has their round-off, which enters v divided by u.M u.
    void find_force() {
        system_.applied_force(t_ + h_ / 2, middle_q_.data(), V_.data(), f_.data());
        noise_ = 1;
        if (!gradient_) return;
        mass_.multiply(half_u_.data(), pulled_.data());
        const Real square = 2 * half_u_.dot(pulled_);
        if (!(square > 0)) return;
        const Real gained = system_.potential(t_, next_q_.data()) - potential_;
        noise_ = max(noise_, Real(h_ * h_ * abs(potential_) / square));
        f_ -= (gained + 2 * half_u_.dot(f_)) / square * pulled_;
    }

    Real size() const override { return motion_; }
    Real round_off() const override { return noise_ * epsilon; }

    System& system_;
    bool gradient_;
    Newton newton_;
    MotionScale scale_;
    BlockMass mass_;
    Predictor changes_;
    VecX w_, turned_, weights_, V_, half_u_, p_, pulled_, f_, next_w_;
    std::vector<Real> half_turn_, middle_q_, next_q_;  // exp(u/2), q exp(u/2), q+
    Real t_ = 0, h_ = 0, known_h_ = 0, motion_ = 0, potential_ = 0, noise_ = 1;
    const Real *q_ = nullptr, *v_ = nullptr;  // start of the step
};

}  // namespace

Factory energy_momentum(StepForce force) {
    Factory factory;
    factory.make = [force](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<EnergyMomentum>(system, force);
    };
    factory.declines = [](const System& system) -> std::string { return system.constraints() > 0 ? "joints" : ""; };
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
