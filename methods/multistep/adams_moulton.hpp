// SPDX-License-Identifier: BSD-3-Clause
//
// Adams-Moulton methods on a Lie group [faltinsen2001], in left trivialisation: the slopes of the last k states, and
// that of the next one, are pulled back into the chart around the newest state, y_n, and integrated there,
//   sigma_j = log(y_n^{-1} y_{n-j}),   k~_j = dexp^{-1}_{-sigma_j}(F(t_n - j h, y_{n-j})),   j = -1, 0, ..., k-1,
//   y_{n+1} = y_n exp(sigma_{-1}),   sigma_{-1} = h sum_j beta_j k~_j,
// which is an equation for the slope k~_{-1} (methods/implicit/stages/implicit_stages.hpp). k steps have order k + 1.
// Own start: k - 1 steps of rkmk/verner6 from (t, y) by -h, after `start`, a failed step and a change of h: the first
// step is as accurate as any other. States that a projection has moved are taken as they are.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// From beta_{-1}, that of the slope at the end of the step, on: one more than the method has steps.
Factory adams_moulton(const std::vector<Coefficient>& weights);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
