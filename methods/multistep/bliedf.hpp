// SPDX-License-Identifier: BSD-3-Clause
//
// BLieDF methods, the backward differentiation formulas on Lie groups, k = 1, 2, 3 [wieloch2021], [arnold2015]: with
//   alpha = (1, -1), (3/2, -2, 1/2), (11/6, -3, 3/2, -1/3),   gamma_i = alpha_0 + ... + alpha_i,
//   v+ = sum_i gamma_i Delta_{n-i},   h v'+ = sum_i alpha_i v_{n+1-i},   M v'+ + C^T lambda+ = Q,
//   q+ = q exp(h D),   D = Delta + h^2/12 [v, v'] (k = 3) - M^{-1} C(q)^T eta,
//   Phi(q+) = 0,   C(q+) v+ + b = 0.
// D_n - h^2/12 [v, v'] is the mean of v over the step up to O(h^3), which is what the formula of k = 3 is for; up to
// k = 2 D itself will do. The bracket, that of left trivialisation, stands at the beginning of the step, where v and v'
// are known. Past Delta are increments that were made, eta included.
// Own start: k - 1 steps of rkmk/rk4 from (t, y) by -h; the index-1 form keeps them on the constraints up to O(h^5). A
// change of h starts afresh.
#pragma once

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Of 1 to 3 steps, in the stabilised index-2 form.
Factory bliedf(int k);
/// The same in the index-3 form: without eta, C v + b = 0 and what follows from it.
Factory bliedf_index3(int k);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
