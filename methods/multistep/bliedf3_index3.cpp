// SPDX-License-Identifier: BSD-3-Clause
//
// BLieDF with k = 3 in the index-3 form, with Phi(q+) = 0 alone [wieloch2021]. Velocities leave C v + b = 0 by the
// local error of the formula, O(h^3), and multipliers start with an error of O(h^2), which the formula damps within
// some steps.
#include "methods/multistep/bliedf.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(bliedf_index3(3), {.name = "multistep/bliedf3_index3",
                                  .order = 3,
                                  .cites = {"wieloch2021", "bruelscardona2010", "munthekaas1998"},
                                  .summary = "backward differentiation formula BLieDF with k = 3, index-3 form",
                                  .variable_cost = true,
                                  .projectable = false,
                                  .form = Form::implicit,
                                  .reports_multipliers = true,
                                  .meets_positions = true,
                                  .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
