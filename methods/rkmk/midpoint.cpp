// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Runge's midpoint rule.
//    0  |
//   1/2 | 1/2
//   ----+--------
//       |  0   1
// Sources: [runge1895], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau midpoint{
    .a = {{}, {{1, 2}}},
    .b = {0, 1},
};

KREISEL_METHOD(rkmk(midpoint), {.name = "rkmk/midpoint",
                                .order = 2,
                                .cites = {"runge1895", "munthekaas1998"},
                                .summary = "Munthe-Kaas lift of the explicit midpoint rule"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
