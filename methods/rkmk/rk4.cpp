// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the classical fourth-order Runge-Kutta method.
//    0  |
//   1/2 | 1/2
//   1/2 |  0   1/2
//    1  |  0    0    1
//   ----+--------------------
//       | 1/6  1/3  1/3  1/6
// Sources: [kutta1901], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau rk4{
    .a = {{}, {{1, 2}}, {0, {1, 2}}, {0, 0, 1}},
    .b = {{1, 6}, {1, 3}, {1, 3}, {1, 6}},
};

KREISEL_METHOD(rkmk(rk4), {.name = "rkmk/rk4",
                           .order = 4,
                           .cites = {"kutta1901", "munthekaas1998"},
                           .summary = "Munthe-Kaas lift of the classical fourth-order method"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
