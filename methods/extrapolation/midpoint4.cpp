// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of the explicit midpoint rule on the group, two columns: 5 solves a step.
// Sources: [gragg1965], [hairer1993, Sec. II.9]; the lift is ours (methods/extrapolation/base.hpp).
#include "methods/extrapolation/extrapolation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(lie_midpoint(2),
               {.name = "extrapolation/midpoint4",
                .order = 4,
                .cites = {"gragg1965", "hairer1993"},
                .summary = "explicit midpoint rule on the group, extrapolated by two columns, no dexpinv; pair 4(2)",
                .estimate = 3});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
