// SPDX-License-Identifier: BSD-3-Clause
//
// Dense output on the group: the state between the ends y_n and y_{n+1} = y(t_n + h) of a step, for any method, from
// the velocities and accelerations there. In the chart q = q_n exp(u) around the start of the step, with s = theta h,
//   u(0) = 0,   u'(0) = v_n,                u''(0) = v'_n,
//   u(h) = u_1, u'(h) = dexp_{-u}^{-1}(v),  u''(h) = dexp_{-u}^{-1}(v' - (d/ds dexp_{-u}) u'),
// and u is the quintic through these six; the velocity is that of the interpolated motion, v = dexp_{-u}(u'). Both meet
// their ends, and v' too. Errors are O(h^6) in q and O(h^5) in v: order 5 and 4. The derivative of dexp is a series,
//   d/ds dexp_{-u} u' = sum_k (-1)^k/(k+1)! S_k,   S_k = [u', ad_u^{k-1} u'] + ad_u S_{k-1},
// of which five terms are taken: what is left out is O(h^7) in u. Source for Hermite interpolation in the algebra:
// [hairer2006, Sec. IV.8], the quintic is ours.
#pragma once

#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class Interpolant {
  public:
    /// Of states in between, in the sense of Order.
    static constexpr int order = 4;

    /// Sizes its work space; the system outlives this.
    explicit Interpolant(System& system);

    /// For the step from y0 at t by h to y1; solves for v' at both ends, which are not counted as solves of the steps.
    /// left_chart where the step turns too far for the chart.
    Status set(const Real& t, const Real& h, const Real* y0, const Real* y1);
    /// y(t + theta h), 0 <= theta <= 1.
    void at(const Real& theta, Real* y);
    /// Solves for v' since construction.
    long evaluations() const { return evaluations_; }

  private:
    /// bent = (d/ds dexp_{-u}) u' for u = u_1 and u' at the end.
    void bend(const Real* u, const Real* du, Real* bent);
    void find_coefficients();

    System& system_;
    std::size_t n_, size_;
    std::vector<Real> start_, inverse_;
    std::vector<Real> u_, du_, ddu_;                     // at the end, times h^0, h, h^2
    std::vector<Real> v_, dv_;                           // at the start, times h and h^2
    std::vector<Real> cubic_, quartic_, quintic_;        // coefficients of theta^3, theta^4, theta^5
    std::vector<Real> power_, term_, sum_, now_, rate_;  // work space
    Real h_ = 0;
    long evaluations_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
