// SPDX-License-Identifier: BSD-3-Clause
//
// The equations of the implicit midpoint rule between two equal projections (midpoint.cpp), for given w = v~+ - v~, mu
// and nu: q~, v~, the middle of the step, q+, v+, and the residuals.
#pragma once

#include <vector>

#include "mechanics/system.hpp"
#include "methods/implicit/motion_scale.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class ProjectedMidpoint {
  public:
    /// Both outlive this.
    ProjectedMidpoint(System& system, const MotionScale& scale);

    Eigen::Index unknowns() const { return n_ + 2 * m_; }

    /// For a step from (q, v) at t by h.
    void begin(const Real& t, const Real& h, const Real* q, const Real* v);
    /// q~, v~, and q+ for x = (w, mu, nu).
    void place(const Real* x);
    /// x - x' of a guess x: w' = h f, and by the KKT matrix at the middle the mu' and nu' that w' calls for.
    Status residual(const Real* x, Real* r);
    /// The same for mu and nu with w held: r = (0, mu - mu', nu - nu').
    Status correction(const Real* x, Real* r);
    /// Whether rows lose rank at q+.
    Status prepare() { return system_.prepare_kkt(end_, configuration_.data()); }

    const std::vector<Real>& configuration() const { return configuration_; }  ///< q+
    /// v+ = v~ + w + G(q+) nu.
    const VecX& velocity(const Real* x);
    const VecX& rate() const { return f_; }  ///< f of the last residual

  private:
    /// shift_ = G(q) multipliers, G = M^{-1} C^T.
    void pull_back(const Real& t, const Real* q, const Real* multipliers);
    void place_end(const Real* mu);
    Status correct(const Real* x, Real* r);

    System& system_;
    const MotionScale& scale_;
    Eigen::Index n_, m_;
    std::vector<Real> start_, middle_, free_, configuration_;      // q~, the middle, q~+, q+
    VecX v_, moved_, middle_v_, f_, u_, shift_, velocity_, zero_;  // n; moved_: v~
    VecX rows_, phi_;                                              // m
    Real t_ = 0, end_ = 0, h_ = 0;
    const Real* q_ = nullptr;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
