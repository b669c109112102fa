// SPDX-License-Identifier: BSD-3-Clause
//
// What implicit methods with multipliers share: the end of a step from the stabilised index-2 form of the equations of
// motion [gear1985], [arnold2016]. A method says how velocity and increment depend on h v' at the end,
//   v+ = a h v'+ + v^,   q+ = q exp(h D),   D = b h v'+ + D^ - C(q)^T eta,
// and (h v'+, h lambda, eta) is found by Newton iteration such that at t+ = t + h
//   h (M v'+ + C^T lambda - Q) = 0,   Phi(t+, q+) / h = 0,   C(t+, q+) v+ + b(t+, q+) = 0.
// Scaled like this (dynamics by h, positions by 1/h) unknowns and residuals keep their size, and the Jacobian its
// condition, as h goes to zero [arnold2016]. Without constraints it is the first row alone.
// The term C^T eta is that of the literature: it takes metres and radians as equal. With levers of hundreds of metres
// it repairs positions by turning bodies, and the iteration converges for short steps only.
#pragma once

#include <vector>

#include "mechanics/system.hpp"
#include "methods/motion_scale.hpp"
#include "methods/newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class StabilisedStep final : private Equations {
  public:
    explicit StabilisedStep(System& system);

    /// a, v^, b and D^ of the method, to be set before `advance`.
    Real velocity_slope, increment_slope;
    VecX velocity_offset, increment_offset;

    /// Fresh guesses from the index-1 form at (t, y); drops whatever earlier steps have left. `rate` becomes h v'.
    Status start(const Real& t, const Real& h, const Real* y);
    /// y(t) -> y(t + h) in place; y stays as it was unless the answer is ok.
    Status advance(const Real& t, const Real& h, Real* y);

    const VecX& rate() const { return rate_; }                  ///< h v' at the end of the last step, or at the start
    const VecX& increment() const { return increment_; }        ///< D of the last step
    const Real* multipliers() const { return lambda_.data(); }  ///< lambda at the end of the last step (N)

  private:
    Status residual(const Real* x, Real* r) override;
    void place(const Real* x);
    void measure_sizes(const Real& t, const Real* y);
    void add_mass_times(const Real* rate, Real* impulse) const;

    System& system_;
    Eigen::Index n_, m_, positions_;
    Newton newton_;
    MotionScale scale_;
    VecX unknowns_, sizes_, rows_scale_;
    MatX jacobian_before_, jacobian_;
    VecX increment_, velocity_, rate_, lambda_, applied_, gyroscopic_;
    std::vector<Real> configuration_, blocks_;
    Real end_ = 0, h_ = 0;
    const Real* q_ = nullptr;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
