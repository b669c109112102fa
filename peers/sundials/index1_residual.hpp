// SPDX-License-Identifier: BSD-3-Clause
//
// The index-1 form on quaternions as a residual, for solvers of differential-algebraic equations: the system's
// equations of motion are evaluated, not solved.
#pragma once

#include "peers/equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Unknowns x = (u, mu): those of PeerEquations and scaled multipliers, lambda = s mu.
///   F = (u_q' - f_q(u),  u_v' + M^{-1} (C^T lambda - Q) / s_v,  (C v' - xi) / s_c)
class Index1Residual {
  public:
    Index1Residual(System& system, PeerEquations& equations);

    std::size_t unknowns() const { return u_size_; }                        ///< of u
    std::size_t size() const { return u_size_ + multiplier_unit_.size(); }  ///< of x

    /// A consistent start at t: x and x' for u, from a solve of the equations of motion. Chooses the scales of
    /// multipliers: mass of the first coordinate, length and rate of the motion.
    Status start(const Real& t, const Real* u, Real* x, Real* dx);
    /// lambda = s mu of x, as forces (N) in the order of the rows of C.
    void multipliers(const Real* x, Real* lambda) const;
    /// False where F is not finite.
    bool evaluate(const Real& t, const Real* x, const Real* dx, Real* F);

  private:
    void choose_scales(const Real* q);

    System& system_;
    PeerEquations& equations_;
    std::size_t u_size_;
    int n_;
    std::vector<Real> y_, z_, lambda_, force_, other_, mass_, row_unit_, multiplier_unit_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
