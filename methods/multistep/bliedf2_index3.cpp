// SPDX-License-Identifier: BSD-3-Clause
//
// BLieDF with k = 2 in the index-3 form, with Phi(q+) = 0 alone [wieloch2021]. Velocities leave C v + b = 0 by the
// local error of the formula, O(h^2), and multipliers start with an error of O(h^1), which the formula damps within
// some steps.
#include "methods/multistep/bliedf.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(bliedf_index3(2), {.name = "multistep/bliedf2_index3",
                                  .order = 2,
                                  .cites = {"wieloch2021", "bruelscardona2010", "munthekaas1998"},
                                  .summary = "backward differentiation formula BLieDF with k = 2, index-3 form",
                                  .variable_cost = true,
                                  .projectable = false,
                                  .form = Form::implicit,
                                  .reports_multipliers = true,
                                  .meets_positions = true,
                                  .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
