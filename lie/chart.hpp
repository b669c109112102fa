// SPDX-License-Identifier: BSD-3-Clause
//
// Local coordinates u around a point q0 of a group: q = q0 psi(u), and the pull-back of q' = q v to them,
// u' = (left-trivialised d psi_u)^{-1}(v). Munthe-Kaas methods run a Runge-Kutta scheme in such coordinates.
#pragma once

#include <memory>

#include "lie/group.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class Chart {
  public:
    virtual ~Chart() = default;
    /// out = q psi(u).
    virtual void append(const Real* q, const Real* u, Real* out) const = 0;
    /// out = u' for q' = q v at q = q0 psi(u). False if u lies outside the chart.
    virtual bool pull_back(const Real* u, const Real* v, Real* out) = 0;
};

/// Canonical coordinates of the first kind, psi = exp, with dexpinv in closed form.
std::unique_ptr<Chart> exp_chart(const Group& group);

/// psi = exp, with dexpinv cut after q brackets: u' = sum_{p=0}^{q} (-1)^p B_p/p! ad_u^p v.
/// q >= p - 2 suffices for order p [hairer2006, Thm IV.8.5]. At most `max_brackets`.
std::unique_ptr<Chart> truncated_exp_chart(const Group& group, int brackets);
inline constexpr int max_brackets = 30;

/// Cayley coordinates, psi = cay, whose inverse differential is a polynomial: there is nothing to truncate.
std::unique_ptr<Chart> cayley_chart(const Group& group);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
