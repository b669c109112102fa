// SPDX-License-Identifier: BSD-3-Clause
//
// Local coordinates u around a point q0 of a group: q = q0 psi(u), and the pull-back of q' = q v to them,
// u' = (left-trivialised d psi_u)^{-1}(v). Munthe-Kaas methods run a Runge-Kutta scheme in such coordinates.
//
// A chart is a plain type, not a virtual interface, so that a step pays only for the group's call:
//   append(q, u, out)      out = q psi(u)
//   pull_back(u, v, out)   out = u' for q' = q v at q = q0 psi(u); false if u lies outside the chart
//   brackets()             those that a pull-back takes
#pragma once

#include <vector>

#include "lie/group.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Canonical coordinates of the first kind, psi = exp, with dexpinv in closed form.
class ExpChart {
  public:
    explicit ExpChart(const Group& group) : group_(&group) {}
    void append(const Real* q, const Real* u, Real* out) const { group_->append_exp(q, u, out); }
    bool pull_back(const Real* u, const Real* v, Real* out) { return group_->dexpinv_left(u, v, out); }
    static int brackets() { return 0; }

  private:
    const Group* group_;
};

inline constexpr int max_brackets = 30;

/// psi = exp, with dexpinv cut after q brackets: u' = sum_{p=0}^{q} (-1)^p B_p/p! ad_u^p v.
/// q >= p - 2 suffices for order p [hairer2006, Thm IV.8.5].
class TruncatedExpChart {
  public:
    /// Throws std::invalid_argument unless 0 <= brackets <= max_brackets.
    TruncatedExpChart(const Group& group, int brackets);
    void append(const Real* q, const Real* u, Real* out) const { group_->append_exp(q, u, out); }
    bool pull_back(const Real* u, const Real* v, Real* out);
    int brackets() const { return static_cast<int>(coefficients_.size()) - 1; }

  private:
    const Group* group_;
    std::vector<Real> power_, sum_, coefficients_;
};

/// Cayley coordinates, psi = cay, whose inverse differential is a polynomial: nothing is truncated. The chart is
/// unbounded: a rotation by pi lies at infinite u.
class CayleyChart {
  public:
    explicit CayleyChart(const Group& group) : group_(&group) {}
    void append(const Real* q, const Real* u, Real* out) const { group_->append_cay(q, u, out); }
    bool pull_back(const Real* u, const Real* v, Real* out) {
        group_->dcayinv_left(u, v, out);
        return true;
    }
    static int brackets() { return 0; }

  private:
    const Group* group_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
