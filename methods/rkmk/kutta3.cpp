// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Kutta's third-order rule.
//    0  |
//   1/2 | 1/2
//    1  | -1    2
//   ----+---------------
//       | 1/6  2/3  1/6
// Sources: [kutta1901], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau kutta3{
    .a = {{}, {{1, 2}}, {-1, 2}},
    .b = {{1, 6}, {2, 3}, {1, 6}},
};

KREISEL_METHOD(rkmk(kutta3), {.name = "rkmk/kutta3",
                              .order = 3,
                              .cites = {"kutta1901", "munthekaas1998"},
                              .summary = "Munthe-Kaas lift of Kutta's third-order rule"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
