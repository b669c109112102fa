// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of Gragg's rule, three columns in one chart: 10 solves a step.
// Sources: [gragg1965], [hairer1993, Sec. II.9], lift [munthekaas1999].
#include "methods/extrapolation/extrapolation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(gragg(3), {.name = "extrapolation/gragg6",
                          .order = 6,
                          .cites = {"gragg1965", "hairer1993", "munthekaas1999"},
                          .summary = "Gragg's rule in one chart, extrapolated by three columns; pair 6(4)",
                          .estimate = 5});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
