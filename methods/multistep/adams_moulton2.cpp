// SPDX-License-Identifier: BSD-3-Clause
//
// Adams-Moulton method with 2 steps on a Lie group, order 3: beta = 5/12, 2/3, -1/12.
// Sources: weights [hairer1993, Sec. III.1], on groups [faltinsen2001], start [verner2010].
#include "methods/multistep/adams_moulton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const std::vector<Coefficient> adams_moulton2 = {{5, 12}, {2, 3}, {-1, 12}};

KREISEL_METHOD(adams_moulton(adams_moulton2), {.name = "multistep/adams_moulton2",
                                               .order = 3,
                                               .cites = {"faltinsen2001", "hairer1993", "verner2010"},
                                               .summary = "implicit Adams-Moulton method with 2 steps on a Lie group",
                                               .variable_cost = true,
                                               .form = Form::implicit,
                                               .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
