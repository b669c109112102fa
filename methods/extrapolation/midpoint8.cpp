// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of the explicit midpoint rule on the group, four columns: 17 solves a step.
// Sources: [gragg1965], [hairer1993, Sec. II.9]; the lift is ours (methods/extrapolation/base.hpp).
#include "methods/extrapolation/extrapolation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(lie_midpoint(4),
               {.name = "extrapolation/midpoint8",
                .order = 8,
                .cites = {"gragg1965", "hairer1993"},
                .summary = "explicit midpoint rule on the group, extrapolated by four columns, no dexpinv; pair 8(6)",
                .estimate = 7});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
