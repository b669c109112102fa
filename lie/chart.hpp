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

/// Canonical coordinates of the second kind, psi(u) = exp(u_1 e_1) ... exp(u_d e_d) over the basis of each factor of
/// the algebra [owrenmarthinsen2001]. Pull-backs solve, in each factor,
///   v = sum_k u_k' Ad_{r_k}^{-1} e_k,   r_k = exp(u_{k+1} e_{k+1}) ... exp(u_d e_d).
/// A chart of rotations by three angles about axes: it ends where the second one is a quarter turn.
class SecondKindChart {
  public:
    explicit SecondKindChart(const Group& group);
    void append(const Real* q, const Real* u, Real* out);
    bool pull_back(const Real* u, const Real* v, Real* out);
    static int brackets() { return 0; }

  private:
    /// The components k of the factors of u, times `sign`, and zero elsewhere.
    const Real* along(std::size_t k, const Real* u, int sign);

    const Group* group_;
    std::size_t n_, factor_;
    std::vector<Real> direction_, rest_, columns_, system_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
