// SPDX-License-Identifier: BSD-3-Clause
//
// Quasi-Newton iteration for the equations of an implicit step, x = G(x) or r(x) = x - G(x) = 0, down to round-off in
// either precision, without a Jacobian matrix.
//
// G is what a structured solve makes of a guess, so that the Jacobian of r is the identity up to O(h) where nothing is
// stiff. x <- x - H r with H = I is the fixed point iteration; every step teaches H what r did along it, and what H
// knows is kept from solve to solve (methods/implicit/newton/inverse_jacobian.hpp). Where that gains too little, as
// with stiff springs, Newton steps take over (methods/implicit/newton/newton_step.hpp), whose directions enter H as
// well. `forget` drops H: whoever must not depend on earlier steps calls that. Cost and storage are linear in the
// unknowns where these are many; all storage is sized in advance.
//
// Unknowns are compared by weights that give them one unit. No constant of the iteration has a unit.
#pragma once

#include "methods/implicit/newton/directions.hpp"
#include "methods/implicit/newton/inverse_jacobian.hpp"
#include "methods/implicit/newton/newton_step.hpp"
#include "methods/implicit/newton/weighted_equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class Newton {
  public:
    explicit Newton(Eigen::Index unknowns);

    /// Solves r(x) = 0 from the guess x, in place; `weights` (positive, one per unknown) are to stay the same until
    /// `forget`. Converged if the last correction to x is a few units of round-off, or a few thousand and no
    /// longer decreasing, unless the residual shows that H has lost a direction; and where nothing else helps, if the
    /// correction is no more than measured round-off. Returns `non_finite` if the first residual is not finite, and
    /// `newton_failed` if the iteration does not converge; x is then meaningless.
    Status solve(Equations& equations, const VecX& weights, Real* x);
    /// Discards all information on the Jacobian.
    void forget();
    /// Whether it has needed Newton steps: the solution then changes too fast for polynomial prediction.
    bool stiff() const { return stiff_; }
    /// Since construction.
    long iterations() const { return iterations_; }

  private:
    /// How the iteration is doing, by largest entries.
    struct Progress {
        Real correction;           // |H r| at x_
        Real before = 0;           // the one before the last step; 0 where there is none to compare with
        Real residual_before = 0;  // |r| then
        bool quiet = false;        // what is left is about round-off
        bool newton_step = false;  // the last step was one
        int slow = 0, still = 0;   // steps that gained little, above round-off and at it
        int newton_steps = 0;
    };
    Status iterate();
    /// Counts the last step if it gained little.
    void assess(Progress& progress) const;
    bool converged(const Progress& progress) const;
    /// Whether H makes less of the residual than any Jacobian would of the steps seen so far.
    bool hides_residual(const Progress& progress) const;
    /// Whether the correction at x_ is no more than what round-off of the residual makes of it: that of stiff forces is
    /// relative to terms far larger than their sum, of which the equations know nothing.
    bool is_noise();
    /// g_ becomes a Newton step.
    Status plan_newton_step(Progress& progress);
    /// x_ -= g_, where g_ = H r_ or a Newton step; r_ and g_ are then those of the new point.
    Status take_step(const Progress& progress);
    /// The Newton step that has led to x_, or the half of it, ..., that makes the correction smaller.
    Status backtrack(const Real& before);
    bool came_nearer(const Progress& progress) const;
    void keep_best();
    void return_to_best();

    /// Residual r_ at x_, and the correction g_ = H r_.
    Status evaluate();
    /// u_ = -(1/|p|) g where p_ = r - before_ is new; H p = s then holds for the step s that has led from before_ to r.
    void learn_from_step();
    /// `units` of round-off in the unknowns.
    Real round_off(int units) const { return units * equations_.round_off() * equations_.size(); }
    Eigen::Index keep() const;

    WeightedEquations equations_;
    InverseJacobian H_;
    Directions directions_;  // the last p of this solve that H knows
    NewtonStep newton_;
    long iterations_ = 0;
    bool stiff_ = false;  // has needed a Newton step, and H comes from such steps
    Real residual_ = 0;   // largest entry of r_
    Real best_size_ = 1;  // where best_r_ is
    VecX x_, r_, before_, best_x_, best_r_, g_, u_, p_, back_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
