// SPDX-License-Identifier: BSD-3-Clause
#include "methods/multistep/bliedf.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(bliedf(1), {.name = "multistep/bliedf1",
                           .order = 1,
                           .cites = {"wieloch2021", "gear1985", "munthekaas1998"},
                           .summary = "backward differentiation formula BLieDF with k = 1, stabilised index-2 form",
                           .variable_cost = true,
                           .form = Form::implicit,
                           .reports_multipliers = true,
                           .meets_positions = true,
                           .meets_velocities = true,
                           .keeps_memory = true,
                           .preserves = {{Property::constraints, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
