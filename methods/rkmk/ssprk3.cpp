// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the third-order method of Shu and Osher, whose classical form preserves strong stability.
//    0  |
//    1  |  1
//   1/2 | 1/4  1/4
//   ----+---------------
//       | 1/6  1/6  2/3
// Sources: [shu1988, eq. (2.18)], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau ssprk3{
    .a = {{}, {1}, {{1, 4}, {1, 4}}},
    .b = {{1, 6}, {1, 6}, {2, 3}},
};

KREISEL_METHOD(rkmk(ssprk3), {.name = "rkmk/ssprk3",
                              .order = 3,
                              .cites = {"shu1988", "munthekaas1998"},
                              .summary = "Munthe-Kaas lift of the third-order method of Shu and Osher (SSPRK3)"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
