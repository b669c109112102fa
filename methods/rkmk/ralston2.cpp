// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Ralston's second-order rule, of least error bound.
//    0  |
//   2/3 | 2/3
//   ----+----------
//       | 1/4  3/4
// Sources: [ralston1962], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau ralston2{
    .a = {{}, {{2, 3}}},
    .b = {{1, 4}, {3, 4}},
};

KREISEL_METHOD(rkmk(ralston2), {.name = "rkmk/ralston2",
                                .order = 2,
                                .cites = {"ralston1962", "munthekaas1998"},
                                .summary = "Munthe-Kaas lift of Ralston's second-order rule"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
