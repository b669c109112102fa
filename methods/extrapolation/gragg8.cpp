// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of Gragg's rule, four columns in one chart: 17 solves a step.
// Sources: [gragg1965], [hairer1993, Sec. II.9], lift [munthekaas1999].
#include "methods/extrapolation/extrapolation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(gragg(4), {.name = "extrapolation/gragg8",
                          .order = 8,
                          .cites = {"gragg1965", "hairer1993", "munthekaas1999"},
                          .summary = "Gragg's rule in one chart, extrapolated by four columns; pair 8(6)",
                          .estimate = 7});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
