// SPDX-License-Identifier: BSD-3-Clause
//
// What RATTLie and SHAKELie iterate: the increment D and the impulse mu that lead from (q, v) onto Phi(t+, q+) = 0
// (methods/variational/rattle_equations.hpp). Guesses come from earlier steps.
#pragma once

#include <memory>

#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton/newton.hpp"
#include "methods/implicit/position_weights.hpp"
#include "methods/implicit/predictor.hpp"
#include "methods/variational/rattle_equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class RattleIncrements final : private Equations {
  public:
    RattleIncrements(System& system, std::unique_ptr<RattleEquations> equations);

    /// Forgets earlier steps, and guesses from the index-1 form at y(t) = (q, v): D = v + h/2 v', mu = span lambda.
    Status begin(const Real& t, const Real& h, const Real& span, const Real* y);
    /// D and mu of a step by h from y(t), which is to stay where it is until `remember`. Places are known to round-off,
    /// mu therefore to that over h, however often it is iterated, and with it what it makes of D. Where steps are so
    /// short that this is much beside the motion, the iteration ends there. D is then made to fit to the last mu':
    /// along the motions that the joints allow, where errors add up, it is known h times better. So it is without
    /// joints, unless forces are stiff: an iteration comes to its end from the same side again and again, and by some
    /// eps of each step momenta would drift.
    Status solve(const Real& t, const Real& h, const Real* y);
    /// They help to guess those of the next step.
    void remember();

    /// As the last solve left them.
    RattleEquations& equations() { return *equations_; }
    const RattleEquations& equations() const { return *equations_; }
    const Real* impulse() const { return unknowns_.data() + n_; }  ///< mu
    long iterations() const { return newton_.iterations(); }       ///< since construction

  private:
    Status index_one(const Real& t, const Real* y, const Real* v);
    Status iterate(const Real* y);
    bool is_near() const;
    Status residual(const Real* turned, Real* r) override;
    Real size() const override { return size_; }
    Real round_off() const override { return rows_.remoteness() * system_.kkt_round_off(); }

    System& system_;
    std::unique_ptr<RattleEquations> equations_;
    Eigen::Index n_, m_;
    MotionScale scale_;
    PositionWeights rows_;
    Newton newton_;
    Predictor past_;             // of turned_
    VecX unknowns_, r_;          // D, mu, and what is left of their equations
    VecX turned_, weights_;      // D, mu with D weighted and in space axes
    VecX applied_, gyroscopic_;  // n
    VecX lambda_, bias_;         // m
    Real size_ = 0;
    const Real* q_ = nullptr;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
