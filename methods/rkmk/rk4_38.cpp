// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Kutta's 3/8 rule.
//    0  |
//   1/3 |  1/3
//   2/3 | -1/3   1
//    1  |   1   -1    1
//   ----+---------------------
//       |  1/8  3/8  3/8  1/8
// Sources: [kutta1901], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau rk4_38{
    .a = {{}, {{1, 3}}, {{-1, 3}, 1}, {1, -1, 1}},
    .b = {{1, 8}, {3, 8}, {3, 8}, {1, 8}},
};

KREISEL_METHOD(rkmk(rk4_38), {.name = "rkmk/rk4_38",
                              .order = 4,
                              .cites = {"kutta1901", "munthekaas1998"},
                              .summary = "Munthe-Kaas lift of Kutta's 3/8 rule"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
