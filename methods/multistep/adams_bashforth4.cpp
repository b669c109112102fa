// SPDX-License-Identifier: BSD-3-Clause
//
// Adams-Bashforth method with 4 steps on a Lie group: beta = 55/24, -59/24, 37/24, -3/8.
// Sources: weights [hairer1993, Sec. III.1], on groups [faltinsen2001], start [munthekaas1998].
#include "methods/multistep/adams_bashforth.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const std::vector<Coefficient> adams_bashforth4 = {{55, 24}, {-59, 24}, {37, 24}, {-3, 8}};

KREISEL_METHOD(adams_bashforth(adams_bashforth4), {.name = "multistep/adams_bashforth4",
                                                   .order = 4,
                                                   .cites = {"faltinsen2001", "hairer1993", "munthekaas1998"},
                                                   .summary = "Adams-Bashforth method with 4 steps on a Lie group",
                                                   .solves_at_start = 12,
                                                   .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
