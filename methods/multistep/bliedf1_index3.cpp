// SPDX-License-Identifier: BSD-3-Clause
//
// BLieDF with k = 1 in the index-3 form, the implicit Euler method with Phi(q+) = 0 alone [wieloch2021]. Velocities are
// quotients of positions, off C v + b = 0 by O(h). Multipliers of the first step are wrong by a part that does not fall
// with h, since it begins on C v + b = 0; from the second step on their error is O(h).
#include "methods/multistep/bliedf.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(bliedf_index3(1), {.name = "multistep/bliedf1_index3",
                                  .order = 1,
                                  .cites = {"wieloch2021", "bruelscardona2010", "munthekaas1998"},
                                  .summary = "backward differentiation formula BLieDF with k = 1, index-3 form",
                                  .variable_cost = true,
                                  .projectable = false,
                                  .form = Form::implicit,
                                  .reports_multipliers = true,
                                  .meets_positions = true,
                                  .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
