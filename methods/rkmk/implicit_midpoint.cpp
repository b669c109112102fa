// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the implicit midpoint rule, the Lie midpoint method: on TG, with y = (q, v),
//   k = F(t + h/2, y exp(h k / 2)),   y+ = y exp(h k),
// that is, with V = (v + v+)/2,
//   q+ = q exp(h V),   v+ = v + h f(t + h/2, q exp(h V / 2), V),   f = v' of the index-1 form.
// The stage k is frozen along its own direction, where dexpinv is the identity and is not needed. Exchanging the
// ends, and h by -h, gives the same equations: the method is symmetric.
//    1/2 | 1/2
//   -----+----
//        |  1
// The unknown of the iteration w = h f (methods/implicit/newton/newton.hpp) is w = v+ - v, and its last f makes the
// step: what is linear in the constraints then holds to the round-off of one solve. Where another group acts on states
// the first line is the method, and the unknown is k (methods/implicit/stages/acted_stages.hpp). Sources: midpoint rule
// [hairer2006], lift [munthekaas1998].
#include "mechanics/actions/acted_upon.hpp"
#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton/newton.hpp"
#include "methods/implicit/predictor.hpp"
#include "methods/implicit/stages/implicit_stages.hpp"
#include "methods/implicit/stages/remoteness.hpp"
#include "methods/rkmk/implicit_rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class ImplicitMidpoint final : public Integrator, private Equations {
  public:
    explicit ImplicitMidpoint(System& system)
        : system_(system),
          newton_(system.velocities()),
          scale_(system),
          changes_(system.velocities()),
          w_(VecX::Zero(system.velocities())),
          turned_(w_),
          weights_(VecX::Ones(w_.size())),
          u_(w_),
          middle_v_(w_),
          f_(w_),
          remoteness_of_(system),
          middle_q_(static_cast<std::size_t>(system.group().size())) {}

    Status start(const Real&, const Real*) override {
        newton_.forget(), scale_.forget(), changes_.clear();
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        t_ = t, h_ = h, q_ = y, v_ = system_.v(y);
        scale_.weigh(y);
        if (const Status status = guess(); status != Status::ok) return status;
        motion_ = scale_.of_motion(t, h, y);
        remoteness_ = remoteness_of_.measure(y);
        const Status status = solve();
        work_.newton_iterations = newton_.iterations();
        if (status != Status::ok) {
            changes_.clear();
            return status;
        }
        w_ = h * f_;
        scale_.to_space(q_, w_.data(), turned_.data());
        changes_.push(turned_);
        Eigen::Map<VecX> v(system_.v(y), w_.size());
        u_ = h * (v + w_ / 2);
        v += w_;
        system_.group().append_exp(y, u_.data(), y);
        return Status::ok;
    }

  private:
    /// w in space axes from the steps before, or h f at the start and where something is stiff.
    Status guess() {
        if (h_ != known_h_) newton_.forget(), changes_.clear();
        known_h_ = h_;
        if (changes_.empty() || newton_.stiff()) {
            const Status status = system_.evaluate(t_, q_, v_, f_.data());
            w_ = h_ * f_;
            scale_.to_space(q_, w_.data(), turned_.data());
            return status;
        }
        changes_.guess(changes_.best_degree(w_.size()), turned_);
        return Status::ok;
    }

    /// From the guess, and where that leads nowhere from an unchanged velocity: springs that are stiff make w swing.
    Status solve() {
        const Status status = newton_.solve(*this, weights_, turned_.data());
        if (status != Status::newton_failed) return status;
        turned_.setZero();
        return newton_.solve(*this, weights_, turned_.data());
    }

    /// Iterates may turn farther than the final step: only the last one is checked, at the end of the step.
    /// r = w - h f(t + h/2, q exp(h V / 2), V) with V = v + w/2.
    Status residual(const Real* turned, Real* r) override {
        scale_.from_space(q_, turned, w_.data());
        middle_v_ = Eigen::Map<const VecX>(v_, w_.size()) + w_ / 2;
        u_ = h_ / 2 * middle_v_;
        system_.group().append_exp(q_, u_.data(), middle_q_.data());
        const Status status = system_.evaluate(t_ + h_ / 2, middle_q_.data(), middle_v_.data(), f_.data());
        u_ = w_ - h_ * f_;
        scale_.to_space(q_, u_.data(), r);
        return status == Status::turn_lost ? Status::ok : status;
    }

    Real size() const override { return max(motion_, Real(abs(h_) * scale_.of_velocity(f_.data()))); }
    Real round_off() const override { return remoteness_ * system_.kkt_round_off(); }

    System& system_;
    Newton newton_;
    MotionScale scale_;
    Predictor changes_;
    VecX w_, turned_, weights_, u_, middle_v_, f_;
    Remoteness remoteness_of_;
    std::vector<Real> middle_q_;
    Real t_ = 0, h_ = 0, known_h_ = 0, motion_ = 0, remoteness_ = 1;
    const Real *q_ = nullptr, *v_ = nullptr;  // start of the step
};

/// Around the middle of the step, where it lies.
StageCoefficients middle_stage() {
    const MatX half = MatX::Constant(1, 1, Real(1) / 2);
    return {half, half, VecX::Ones(1), VecX::Constant(1, Real(1) / 2)};
}

Factory implicit_midpoint() {
    Factory factory;
    factory.make = [](System& system, const OptionValues&, const MethodDescription&) -> std::unique_ptr<Integrator> {
        if (action_on(system)) return implicit_runge_kutta(system, middle_stage(), true);
        return std::make_unique<ImplicitMidpoint>(system);
    };
    factory.stages = 1;
    factory.takes_actions = true;
    return factory;
}

}  // namespace

KREISEL_METHOD(implicit_midpoint(), {.name = "rkmk/implicit_midpoint",
                                     .order = 2,
                                     .cites = {"hairer2006", "munthekaas1998"},
                                     .summary = "Munthe-Kaas lift of the implicit midpoint rule",
                                     .variable_cost = true,
                                     .form = Form::implicit,
                                     .preserves = {{Property::symmetric, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
