// SPDX-License-Identifier: BSD-3-Clause
//
// Adams-Moulton method with 3 steps on a Lie group, order 4: beta = 3/8, 19/24, -5/24, 1/24.
// Sources: weights [hairer1993, Sec. III.1], on groups [faltinsen2001], start [verner2010].
#include "methods/multistep/adams_moulton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const std::vector<Coefficient> adams_moulton3 = {{3, 8}, {19, 24}, {-5, 24}, {1, 24}};

KREISEL_METHOD(adams_moulton(adams_moulton3), {.name = "multistep/adams_moulton3",
                                               .order = 4,
                                               .cites = {"faltinsen2001", "hairer1993", "verner2010"},
                                               .summary = "implicit Adams-Moulton method with 3 steps on a Lie group",
                                               .variable_cost = true,
                                               .form = Form::implicit,
                                               .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
