// SPDX-License-Identifier: BSD-3-Clause
//
// Adams-Moulton method with 4 steps on a Lie group, order 5: beta = 251/720, 323/360, -11/30, 53/360, -19/720.
// Sources: weights [hairer1993, Sec. III.1], on groups [faltinsen2001], start [verner2010].
#include "methods/multistep/adams_moulton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const std::vector<Coefficient> adams_moulton4 = {{251, 720}, {323, 360}, {-11, 30}, {53, 360}, {-19, 720}};

KREISEL_METHOD(adams_moulton(adams_moulton4), {.name = "multistep/adams_moulton4",
                                               .order = 5,
                                               .cites = {"faltinsen2001", "hairer1993", "verner2010"},
                                               .summary = "implicit Adams-Moulton method with 4 steps on a Lie group",
                                               .variable_cost = true,
                                               .form = Form::implicit,
                                               .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
