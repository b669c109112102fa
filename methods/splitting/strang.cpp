// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting of Strang: half a kick, free motion, half a kick; Stoermer-Verlet with the free motion of a body in place
// of that of a point.
// Source: [hairer2006, Sec. II.5, eq. 5.3].
#include "methods/splitting/splitting.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const SplittingScheme strang{.kicks = {{1, 2}}, .drifts = {1}};

KREISEL_METHOD(splitting(strang), {.name = "splitting/strang",
                                   .order = 2,
                                   .cites = {"celledonifasso2008", "hairer2006"},
                                   .summary = "exact free motion between kicks, Strang",
                                   .force_evaluations = 2,
                                   .preserves = preserved_by_splitting(),
                                   .formulations = formulations_of_splitting});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
