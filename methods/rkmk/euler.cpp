// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Euler's method: y exp(h F).
//   0 |
//   --+--
//     | 1
// Sources: [euler1768], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau euler{
    .a = {{}},
    .b = {1},
};

KREISEL_METHOD(rkmk(euler), {.name = "rkmk/euler",
                             .order = 1,
                             .cites = {"euler1768", "munthekaas1998"},
                             .summary = "Lie-Euler: one exponential of the frozen slope"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
