// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Ralston's third-order rule.
//    0  |
//   1/2 | 1/2
//   3/4 |  0   3/4
//   ----+---------------
//       | 2/9  1/3  4/9
// Sources: [ralston1962], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau ralston3{
    .a = {{}, {{1, 2}}, {0, {3, 4}}},
    .b = {{2, 9}, {1, 3}, {4, 9}},
};

KREISEL_METHOD(rkmk(ralston3), {.name = "rkmk/ralston3",
                                .order = 3,
                                .cites = {"ralston1962", "munthekaas1998"},
                                .summary = "Munthe-Kaas lift of Ralston's third-order rule"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
