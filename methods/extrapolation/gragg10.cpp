// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of Gragg's rule, five columns in one chart: 26 solves a step.
// Sources: [gragg1965], [hairer1993, Sec. II.9], lift [munthekaas1999].
#include "methods/extrapolation/extrapolation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(gragg(5), {.name = "extrapolation/gragg10",
                          .order = 10,
                          .cites = {"gragg1965", "hairer1993", "munthekaas1999"},
                          .summary = "Gragg's rule in one chart, extrapolated by five columns; pair 10(8)",
                          .estimate = 9});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
