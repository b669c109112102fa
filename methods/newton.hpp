// SPDX-License-Identifier: BSD-3-Clause
//
// Simplified Newton iteration for the equations of an implicit step, down to round-off in either precision.
//
// The Jacobian comes from forward differences, unknown j moved by sqrt(eps) times its size: the quotient is good to
// some sqrt(eps), which costs the iteration nothing, because every further step gains that factor at least. It is kept
// from solve to solve and differentiated again once an iteration gains less than a factor of four. `forget` drops it:
// whoever must not depend on earlier steps calls that. Dense LU with partial pivoting, all storage sized in advance.
#pragma once

#include <Eigen/LU>

#include "lie/linear.hpp"
#include "lie/status.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// r(x) = 0, as many equations as unknowns.
class Equations {
  public:
    virtual ~Equations() = default;
    /// Any status but ok ends the iteration with that status.
    virtual Status residual(const Real* x, Real* r) = 0;
};

class Newton {
  public:
    explicit Newton(int unknowns);

    /// Solves r(x) = 0 from the guess x, in place. `size` (positive, one per unknown) is what an unknown's round-off is
    /// relative to; an iteration has converged when the next correction would fall below eps, or when corrections of
    /// some thousand eps no longer fall. Answers `non_finite` where a residual or a derivative is not a number, and
    /// `newton_failed` where the corrections do not converge; x is then of no use.
    Status solve(Equations& equations, const Real* size, Real* x);
    /// Drops the Jacobian.
    void forget() { known_ = false; }

  private:
    Status iterate(Equations& equations, const Real* size, Real* x);
    Status differentiate(Equations& equations, const Real* size, Real* x);
    /// Largest |correction| relative to `size`; not finite where one is not.
    Real relative_correction(const Real* size) const;

    bool known_ = false;
    VecX residual_, moved_, correction_;
    VecX row_weight_, column_size_;  // equilibrate the Jacobian: pivoting compares entries of different units
    MatX jacobian_;
    Eigen::PartialPivLU<MatX> lu_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
