// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Heun's second-order rule.
//   0 |
//   1 |  1
//   --+----------
//     | 1/2  1/2
// Sources: [heun1900], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau heun{
    .a = {{}, {1}},
    .b = {{1, 2}, {1, 2}},
};

KREISEL_METHOD(rkmk(heun), {.name = "rkmk/heun",
                            .order = 2,
                            .cites = {"heun1900", "munthekaas1998"},
                            .summary = "Munthe-Kaas lift of Heun's trapezoidal rule"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
