// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of Gragg's rule, two columns in one chart: 5 solves a step.
// Sources: [gragg1965], [hairer1993, Sec. II.9], lift [munthekaas1999].
#include "methods/extrapolation/extrapolation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(gragg(2), {.name = "extrapolation/gragg4",
                          .order = 4,
                          .cites = {"gragg1965", "hairer1993", "munthekaas1999"},
                          .summary = "Gragg's rule in one chart, extrapolated by two columns; pair 4(2)",
                          .estimate = 3});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
