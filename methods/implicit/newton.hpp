// SPDX-License-Identifier: BSD-3-Clause
//
// Quasi-Newton iteration for the equations of an implicit step, x = G(x) or r(x) = x - G(x) = 0, down to round-off in
// either precision, without a Jacobian matrix.
//
// G is what a structured solve makes of a guess, so that the Jacobian of r is the identity up to O(h) where nothing is
// stiff. x <- x - H r with H = I is the fixed point iteration; every step teaches H what r did along it, and what H
// knows is kept from solve to solve (methods/implicit/inverse_jacobian.hpp). Where that gains too little, as with stiff
// springs, the linear equations of a Newton step are solved by conjugate residuals [saad2003, Sec. 6.9] preconditioned
// with H, products with the Jacobian being difference quotients of r: their directions enter H as well. `forget` drops
// H: whoever must not depend on earlier steps calls that. Cost and storage are linear in the unknowns where these are
// many; all storage is sized in advance.
//
// Unknowns are compared by weights that give them one unit. No constant of the iteration has a unit.
#pragma once

#include "lie/linear.hpp"
#include "lie/status.hpp"
#include "methods/implicit/inverse_jacobian.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// r(x) = 0, as many equations as unknowns, each equation with the unit of its unknown.
class Equations {
  public:
    virtual ~Equations() = default;
    /// Any status but ok ends the iteration with that status.
    virtual Status residual(const Real* x, Real* r) = 0;
    /// After `residual`: size of the weighted unknowns, what their round-off is relative to.
    virtual Real size() const = 0;
    /// Relative round-off of a residual: eps times the condition of its solves.
    virtual Real round_off() const { return epsilon; }
};

class Newton {
  public:
    explicit Newton(Eigen::Index unknowns);

    /// Solves r(x) = 0 from the guess x, in place; `weights` (positive, one per unknown) are to stay the same until
    /// `forget`. Converged if the last correction to x is a few units of round-off, or a few thousand and no
    /// longer decreasing. Returns `non_finite` if the first residual is not finite, and `newton_failed` if the
    /// iteration does not converge; x is then meaningless.
    Status solve(Equations& equations, const VecX& weights, Real* x);
    /// Discards all information on the Jacobian.
    void forget();
    /// Whether it has needed Newton steps: the solution then changes too fast for polynomial prediction.
    bool stiff() const { return stiff_; }

  private:
    Status iterate(Equations& equations);
    /// Residual at plain_ into r, weighted, and its largest entry; non_finite where an entry is no number.
    Status evaluate(Equations& equations, VecX& r);
    bool converged(const Real& now, const Real& before, int still, bool newton_step) const;
    /// Solves J s = r up to a small share by directions that enter H.
    Status probe(Equations& equations);
    Status search(Equations& equations, const Real& before);
    Status difference(Equations& equations, const Real& step);
    /// u_ = -(1/|p|) g where p_ = r - before_ is new; H p = s then holds for the step s that has led from before_ to r.
    void learn_from_step(const Real& noise);
    /// p_ less its part in the directions of this solve, normalised; its length before, or 0 if too little is left.
    Real orthonormalise(int share);
    Eigen::Index keep() const;
    void keep_best();
    /// Residual r_ at x_, and the correction g_ = H r_.
    Status move(Equations& equations);

    InverseJacobian H_;
    bool stiff_ = false;           // has needed a Newton step, and H comes from such steps
    Real gain_ = 1;                // of the Jacobian, by largest entries
    Eigen::Index directions_ = 0;  // found in this solve
    const VecX* weights_ = nullptr;
    Real size_ = 1, round_off_ = 1, largest_ = 0;  // of the last evaluation
    Real residual_ = 0;                            // largest entry of r_
    Real best_size_ = 1;                           // where best_r_ is
    VecX x_, plain_, r_, before_, best_x_, best_r_, g_, u_, p_, rest_, moved_, newton_step_;
    MatX group_;  // the last p of this solve that H knows, orthonormal columns
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
