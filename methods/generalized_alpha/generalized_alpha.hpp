// SPDX-License-Identifier: BSD-3-Clause
//
// The generalised-alpha method on Lie groups [bruels2012], [arnold2015]:
//   q+ = q exp(h D),   D = v + (1/2 - beta) h a + beta h a+,   v+ = v + (1 - gamma) h a + gamma h a+,
//   (1 - alpha_m) a+ + alpha_m a = (1 - alpha_f) v'+ + alpha_f v',   M v'+ + C^T lambda+ = Q
// with the constraints of the form that `Step` solves (StabilisedStep, PositionStep).
// The auxiliary a is v' at t + (alpha_m - alpha_f) h. So it starts as v'(0) + (alpha_m - alpha_f) h v''(0); any other
// start costs an order in the first steps [arnold2016]. v'' is the central difference of the index-1 v' along the flow
// over h/8: its error is O(h^2), its round-off in a stays some eps v'. A change of h starts the method afresh.
#pragma once

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/generalized_alpha/parameters.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Step>
class GeneralisedAlpha : public Integrator {
  public:
    GeneralisedAlpha(System& system, const AlphaParameters& parameters)
        : system_(system),
          p_(parameters),
          step_(system),
          v_(VecX::Zero(system.velocities())),
          jerk_(v_),
          a_(v_),
          a_known_(v_),
          rate_(v_),
          near_rate_(v_),
          shift_(v_),
          near_(static_cast<std::size_t>(system.state_group().size())) {}

    Status start(const Real&, const Real*) override {
        h_ = 0;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.evaluate(t, y, system_.v(y), near_rate_.data());
        v_ = Eigen::Map<const VecX>(system_.v(y), v_.size());
        if (h != h_)
            if (const Status status = begin(t, h, y); status != Status::ok) return status;
        h_ = 0;  // until this step has succeeded
        set_relations();
        const Status status = step_.advance(t, h, y);
        work_.newton_iterations = step_.iterations();
        if (status != Status::ok) return status;
        a_ = a_known_ + a_slope() * step_.rate();
        h_ = h, stepped_ = true;
        return Status::ok;
    }

    const Real* multipliers() const override { return stepped_ ? step_.multipliers() : nullptr; }

  protected:
    /// Before the first step from (t, y), where rate_ = h v' and jerk_ = h^2 v'': what v_ starts as.
    virtual Status perturb(const Real& /*t*/, const Real& /*h*/, const Real* /*y*/) { return Status::ok; }

    System& system_;
    const AlphaParameters p_;
    Step step_;
    VecX v_, jerk_;                                // where a step starts
    VecX a_, a_known_, rate_, near_rate_, shift_;  // a times h; the part of h a+ that is known; h v'

  private:
    /// d a+ / d v'+.
    Real a_slope() const { return (1 - p_.alpha_f) / (1 - p_.alpha_m); }

    /// h a at the start.
    Status begin(const Real& t, const Real& h, const Real* y) {
        stepped_ = false;
        if (const Status status = step_.start(t, h, y); status != Status::ok) return status;
        rate_ = step_.rate();
        const Real near = Real(1) / 8;  // in units of h
        a_ = rate_;
        jerk_.setZero();
        for (const int side : {1, -1}) {
            if (const Status status = rate_along_flow(t, h, side * near, y); status != Status::ok) return status;
            a_ += (p_.alpha_m - p_.alpha_f) * side / (2 * near) * near_rate_;
            jerk_ += side / (2 * near) * near_rate_;
        }
        return perturb(t, h, y);
    }

    /// near_rate_ = h v' at t + d h on the flow through y, up to O(d^3 h^3) in q and O(d^2 h^2) in v (even in d).
    Status rate_along_flow(const Real& t, const Real& h, const Real& d, const Real* y) {
        const Real* v = system_.v(y);
        Real* near_v = system_.v(near_.data());
        for (Eigen::Index i = 0; i < shift_.size(); ++i) {
            shift_[i] = d * h * (v[i] + d * rate_[i] / 2);
            near_v[i] = v[i] + d * rate_[i];
        }
        system_.group().append_exp(y, shift_.data(), near_.data());
        const Status status = system_.evaluate(t + d * h, near_.data(), near_v, near_rate_.data());
        near_rate_ *= h;
        return status;
    }

    /// v+ and D as functions of h v'+.
    void set_relations() {
        a_known_ = (p_.alpha_f * step_.rate() - p_.alpha_m * a_) / (1 - p_.alpha_m);
        step_.velocity_slope = p_.gamma * a_slope();
        step_.velocity_offset = v_ + (1 - p_.gamma) * a_ + p_.gamma * a_known_;
        step_.increment_slope = p_.beta * a_slope();
        step_.increment_offset = v_ + (Real(1) / 2 - p_.beta) * a_ + p_.beta * a_known_;
    }

    std::vector<Real> near_;
    Real h_ = 0;  // step that the memory belongs to; 0: none
    bool stepped_ = false;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
