// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of the explicit midpoint rule on the group, five columns: 26 solves a step.
// Sources: [gragg1965], [hairer1993, Sec. II.9]; the lift is ours (methods/extrapolation/base.hpp).
#include "methods/extrapolation/extrapolation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(lie_midpoint(5),
               {.name = "extrapolation/midpoint10",
                .order = 10,
                .cites = {"gragg1965", "hairer1993"},
                .summary = "explicit midpoint rule on the group, extrapolated by five columns, no dexpinv; pair 10(8)",
                .estimate = 9});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
