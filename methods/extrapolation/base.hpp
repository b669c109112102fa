// SPDX-License-Identifier: BSD-3-Clause
//
// The base methods of extrapolation: the explicit midpoint rule over a step by H in n (even) substeps h = H/n, lifted
// to TG in two ways; each gives its result as coordinates u in a linear space in which
//   u(h) = u(0) + e_1 h^2 + e_2 h^4 + ...,
// so that Aitken-Neville extrapolation in h^2 gives order 2k from k of them [gragg1965].
//
// In a chart (Gragg's rule), y = y_n exp(u):  with k~_i = dexp^{-1}_{-u_i}(F(t_n + i h, y_n exp(u_i))),
//   u_1 = h k~_0,   u_{i+1} = u_{i-1} + 2 h k~_i.
// That is the rule of the literature for u' = dexp^{-1}_{-u}(F), with its expansion [hairer1993, Thm II.9.1]. The step
// that smooths the end there is not needed: at even i there is no odd power of h.
//
// On the group:
//   y_1 = y_n exp(h F_0),   y_{i+1} = y_{i-1} exp(2 h F_i),   F_i = F(t_n + i h, y_i).
// With a_k = y_{2k} and b_k = y_{2k+1} exp(-h F(a_k)) this is the one-step method
//   a+ = a exp(2h F(b exp(h F(a)))),   b+ = b exp(h F(a)) exp(h F(a+)),   a_0 = b_0 = y_n,
// on pairs, which is symmetric: exchanging the ends, and h by -h, gives the same equations. The error of a_k therefore
// has an expansion in h^2 [hairer1993, Thm II.8.10], in any coordinates of the pairs. Its coordinates are
// u = log(a^{-1} y), a the result of the first row: fixed during a step and near all others, so that a step meets no
// limit of a chart, however far it turns.
#pragma once

#include "lie/real.hpp"
#include "lie/status.hpp"
#include "methods/contract/integrator.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class System;

class ExtrapolationBase {
  public:
    explicit ExtrapolationBase(Work& work) : work_(work) {}
    virtual ~ExtrapolationBase() = default;
    /// A step by H from y(t), which must remain until its end. `known`: y is that of the step before, which was
    /// rejected, and its first slope is still right.
    virtual Status begin(const Real& t, const Real& H, const Real* y, bool known) = 0;
    /// Coordinates (dim TG) of the result with n substeps. The rows of a step come in a fixed order, from the first.
    virtual Status row(int n, Real* u) = 0;
    /// The state with coordinates u; may be written over that of the start.
    virtual void state(const Real* u, Real* y) = 0;

  protected:
    Work& work_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
