// SPDX-License-Identifier: BSD-3-Clause
//
// Adams-Bashforth method with 3 steps on a Lie group: beta = 23/12, -4/3, 5/12.
// Sources: weights [hairer1993, Sec. III.1], on groups [faltinsen2001], start [munthekaas1998].
#include "methods/multistep/adams_bashforth.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const std::vector<Coefficient> adams_bashforth3 = {{23, 12}, {-4, 3}, {5, 12}};

KREISEL_METHOD(adams_bashforth(adams_bashforth3), {.name = "multistep/adams_bashforth3",
                                                   .order = 3,
                                                   .cites = {"faltinsen2001", "hairer1993", "munthekaas1998"},
                                                   .summary = "Adams-Bashforth method with 3 steps on a Lie group",
                                                   .solves_at_start = 8,
                                                   .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
