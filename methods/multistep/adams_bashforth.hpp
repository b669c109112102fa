// SPDX-License-Identifier: BSD-3-Clause
//
// Adams-Bashforth methods on a Lie group [faltinsen2001], in left trivialisation: the slopes of the last k states are
// pulled back into the chart around the newest one, y_n, and integrated there,
//   sigma_j = log(y_n^{-1} y_{n-j}),   k~_j = dexp^{-1}_{-sigma_j}(F(t_n - j h, y_{n-j})),
//   y_{n+1} = y_n exp(h sum_j beta_j k~_j),   j = 0, ..., k-1.
// Slopes of different points, added as they are, would leave order 2. One solve per step.
// Own start: k - 1 steps of rkmk/rk4, after `start`, a failed step and a change of h. States that a projection has
// moved are taken as they are.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// From beta_0, that of the newest slope, on: as many as the method has steps.
Factory adams_bashforth(const std::vector<Coefficient>& weights);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
