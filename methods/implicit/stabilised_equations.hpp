// SPDX-License-Identifier: BSD-3-Clause
//
// The stabilised index-2 form at the end of a step (methods/implicit/stabilised_step.hpp has the equations): what a
// guess of x = h v' and eta makes of q+, v+ and D, and the two solves with the KKT matrix at (t+, q+) that give the
// next guess.
#pragma once

#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// How a method has velocity and increment depend on x at the end:
/// v+ = a x + v^,  q+ = q exp(h D),  D = b x + D^ - M^{-1} C(q)^T eta.
struct StepRelations {
    explicit StepRelations(Eigen::Index n) : velocity_offset(VecX::Zero(n)), increment_offset(velocity_offset) {}

    Real velocity_slope = 0, increment_slope = 0;  ///< a, b
    VecX velocity_offset, increment_offset;        ///< v^, D^
};

class StabilisedEquations {
  public:
    /// Both outlive this.
    StabilisedEquations(System& system, const StepRelations& relations);

    /// etas: all rows, or none where no row has a position level.
    Eigen::Index etas() const { return positions_ > 0 ? m_ : 0; }

    /// For a step from q at t by h.
    void begin(const Real& t, const Real& h, const Real* q) { start_ = t, end_ = t + h, h_ = h, q_ = q; }
    /// q+, v+ and D for x and eta, one after the other.
    void place(const Real* unknowns);
    /// h Q there.
    const VecX& evaluate_forces();
    /// After that: [M C+^T; C+ 0] (x', h lambda) = (h Q, -(b+ + C+ v^) / a).
    Status solve_dynamics();
    /// [M C+^T; C+ 0] (., eta - eta') = (0, C+ b (x' - x) + Phi / h); rows without a position level have
    /// C+ M^{-1} C^T eta in place of the latter.
    Status correct_positions(const Real* x, Real* change);
    /// C+ v+ + b+ = 0 by a change of x'.
    Status correct_rate();
    /// Phi at q+, the first entries.
    const VecX& position_residual();
    /// Factors at q+.
    Status prepare() { return system_.prepare_kkt(end_, configuration_.data()); }
    /// v+ of x'.
    const VecX& velocity_of_rate() { return velocity_ = relations_.velocity_slope * rate + relations_.velocity_offset; }
    /// Back to where the step began.
    void withdraw();

    const std::vector<Real>& configuration() const { return configuration_; }  ///< q+
    const Real& time() const { return end_; }                                  ///< t+
    const VecX& increment() const { return increment_; }                       ///< D
    const VecX& impulse() const { return impulse_; }                           ///< h lambda

    VecX rate;    ///< x'
    VecX change;  ///< eta - eta' of the last correction

  private:
    /// shift_ = M^{-1} C(q)^T eta.
    void pull_back(const Real* eta);

    System& system_;
    const StepRelations& relations_;
    Eigen::Index n_, m_, positions_;
    std::vector<Real> configuration_;
    VecX increment_, velocity_, force_, gyroscopic_, shift_;  // n
    VecX rows_, impulse_;                                     // m
    Real start_ = 0, end_ = 0, h_ = 0;
    const Real* q_ = nullptr;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
