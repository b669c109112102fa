// SPDX-License-Identifier: BSD-3-Clause
//
// Adams-Bashforth method with 2 steps on a Lie group: beta = 3/2, -1/2.
// Sources: weights [hairer1993, Sec. III.1], on groups [faltinsen2001], start [munthekaas1998].
#include "methods/multistep/adams_bashforth.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const std::vector<Coefficient> adams_bashforth2 = {{3, 2}, {-1, 2}};

KREISEL_METHOD(adams_bashforth(adams_bashforth2), {.name = "multistep/adams_bashforth2",
                                                   .order = 2,
                                                   .cites = {"faltinsen2001", "hairer1993", "munthekaas1998"},
                                                   .summary = "Adams-Bashforth method with 2 steps on a Lie group",
                                                   .solves_at_start = 4,
                                                   .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
