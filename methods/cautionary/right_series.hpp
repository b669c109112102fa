// SPDX-License-Identifier: BSD-3-Clause
//
// The trap of mixed trivialisations: a Munthe-Kaas lift whose kinematics is left-trivialised, q = q_n exp(u), and whose
// series for dexpinv is the right-trivialised one,
//   u' = dexp^{-1}_u(v) = v - 1/2 [u, v] + 1/12 [u, [u, v]] - ...   in place of   v + 1/2 [u, v] + ...,
// as the formulas of [terzezlatarmueller] read, taken literally (NOTATION.md, corrections to the seed paper). Nothing
// crashes, every rotation stays orthogonal, and the order is 2, whatever the tableau.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct RightSeriesScheme {
    Tableau tableau;
};

Factory right_series(const Tableau& tableau);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
