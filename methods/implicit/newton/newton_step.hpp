// SPDX-License-Identifier: BSD-3-Clause
//
// The linear equations of a Newton step, J g = r at x, up to a small share: conjugate residuals [saad2003, Sec. 6.9]
// preconditioned with H, an approximate inverse of J. Products with J are difference quotients of r; their directions
// enter H as well.
#pragma once

#include "methods/implicit/newton/directions.hpp"
#include "methods/implicit/newton/inverse_jacobian.hpp"
#include "methods/implicit/newton/weighted_equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class NewtonStep {
  public:
    explicit NewtonStep(Eigen::Index unknowns)
        : rest_(unknowns), moved_(unknowns), step_(unknowns), p_(unknowns), u_(unknowns) {}

    /// g from r at x; `distance` is that of the difference quotients. `directions` become those of J times the
    /// directions that H has learnt.
    Status find(WeightedEquations& equations, const VecX& x, const VecX& r, const Real& distance, InverseJacobian& H,
                Directions& directions, VecX& g);
    /// The largest |J s| / |s| since `forget`, by largest entries; at least 1.
    const Real& gain() const { return gain_; }
    void forget() { gain_ = 1; }

  private:
    /// p_ = J s.
    Status multiply_jacobian(WeightedEquations& equations, const VecX& x, const VecX& r, const VecX& s,
                             const Real& distance);

    Real gain_ = 1;
    VecX rest_, moved_, step_, p_, u_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
