// SPDX-License-Identifier: BSD-3-Clause
//
// The equations of RATTLie and SHAKELie (methods/variational/rattlie.cpp, shakelie.cpp) for given increment D and
// impulse mu: p~ = M D seen from either end of a step, q+, and the residuals.
#pragma once

#include <vector>

#include "mechanics/system.hpp"
#include "methods/implicit/block_mass.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The local coordinates of increments: q+ = q tau(h D).
enum class IncrementChart { exp, cayley };

class RattleEquations {
  public:
    RattleEquations(System& system, IncrementChart chart);
    virtual ~RattleEquations() = default;
    RattleEquations(const RattleEquations&) = delete;
    RattleEquations& operator=(const RattleEquations&) = delete;

    /// For a step from (q, v) at t by h: the known parts of the momentum, M v and h/2 f(t, q).
    void begin(const Real& t, const Real& h, const Real* q, const Real* v);
    /// q+ for D; its unknowns are D (n) and mu (m).
    void place(const Real* D);
    /// x - x' of a guess x = (D, mu): M D' = M v + h/2 f - C(q)^T mu + M D - (d tau^{-1}_{hD})^T M D, and
    /// [M C+^T; C+ 0] (., mu - mu') = (0, C+ (D' - D) + Phi(q+) / h).
    Status residual(const Real* x, Real* r);
    /// x becomes (D+, mu') where r = x - x' is small: D+ is the D' of mu' in place of mu, but for O(h r), and q+ its.
    void settle(Real* x, const Real* r);
    /// v+ and lambda: M v+ + h/2 C+^T lambda = (d tau^{-1}_{-hD})^T M D + h/2 f(t+, q+),  C+ v+ + b+ = 0.
    Status finish(Real* v, Real* lambda);
    /// w+, the velocity before constraints act: M w+ = (d tau^{-1}_{-hD})^T M D + h/2 f(t+, q+).
    Status kick(Real* w);

    const std::vector<Real>& configuration() const { return configuration_; }  ///< q+
    Eigen::Index unknowns() const { return n_ + m_; }

  protected:
    /// out = (d tau^{-1}_{u})^T p, right-trivialised; false outside the chart. Virtual for a control of the tests.
    virtual bool pull_back(const VecX& u, const VecX& p, VecX& out) const;

  private:
    /// force_ = (d tau^{-1}_{-hD})^T M D + h/2 f(t+, q+) - M v; false outside the chart.
    bool gain();

    System& system_;
    IncrementChart chart_;
    Eigen::Index n_, m_, positions_;
    BlockMass mass_;
    std::vector<Real> configuration_;
    VecX v_, start_, push_;                             // n: v, M v, h/2 f(t, q)
    VecX u_, momentum_, pulled_, force_, rate_, zero_;  // n
    VecX rows_;                                         // m
    Real t_ = 0, h_ = 0;
    const Real* q_ = nullptr;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
