// SPDX-License-Identifier: BSD-3-Clause
//
// The second route to a reference: integration by Taylor series in rotation matrices. It shares only the model's data
// with the first route (extrapolation on quaternions, mass and constraints through System).
#pragma once

#include "engine/reference/reference.hpp"
#include "engine/reference/taylor/taylor_series.hpp"
#include "engine/report/report.hpp"
#include "support/watch.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

#if KREISEL_QUAD
inline constexpr int taylor_order = 40;
#else
inline constexpr int taylor_order = 20;
#endif

/// The motion of a model from its start, which is at t_begin; time runs in one direction. Not thread-safe.
class TaylorRoute {
  public:
    explicit TaylorRoute(const Model& model, const Real& t_begin = 0);

    /// Moves on to time t, unless the watch asks to stop; it is told nothing. Returns singular_kkt also if steps shrink
    /// below 2^-40 of the way: the motion has reached a singularity.
    Status advance(const Real& t, const Watch& watch);
    bool interrupted() const { return interrupted_; }

    const std::vector<BodyState>& states() const { return states_; }
    /// Multipliers at the present time (N). Expands the series there.
    Status multipliers(std::vector<Real>& lambda);
    /// The same by the series that led there.
    std::vector<Real> multipliers() const { return series_.multipliers(t_ - base_t_); }
    /// Expansions so far.
    long steps() const { return steps_; }

  private:
    Status expand();

    TaylorSeries series_;
    std::vector<BodyState> states_;
    Real t_, base_t_, reach_ = 0;  // the series stands at base_t_ and holds up to base_t_ + reach_
    bool holds_ = false;           // at t_ and beyond
    bool interrupted_ = false;
    long steps_ = 0;
};

/// reference_solution confirmed by the second route: each error is the larger one of the difference between two step
/// sizes and that between the routes (past the horizon the largest since), and the horizon the last big step up to
/// which these agree to 1e-12 as well. Where the second route fails, the horizon ends, the errors at t_end are unknown,
/// and `route` says so. Samples are confirmed in the same way, each at its time; past the horizon their errors do not
/// fall, and from where the second route fails on they are unknown.
ReferenceSolution confirmed_reference(const Model& model, const Real& t_end, const Watch& watch = {}, long samples = 0,
                                      const Real& t_begin = 0);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
