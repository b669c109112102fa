// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the Radau IIA method with 2 stages, order 3, in coordinates around the start of the step.
//    1/3 | 5/12  -1/12
//     1  | 3/4    1/4
//   -----+-------------
//        | 3/4    1/4
// Stiffly accurate and L-stable: the last stage is the step, and what a stiff damper would end at once ends at once,
// where the stiff components of Gauss methods alternate instead. Sources: [hairer1996, Sec. IV.5], lift
// [munthekaas1999].
#include "methods/rkmk/implicit_rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const ImplicitTableau radau2a2{
    .a = {{{5, 12}, {-1, 12}}, {{3, 4}, {1, 4}}},
    .b = {{3, 4}, {1, 4}},
    .c = {{1, 3}, 1},
};

KREISEL_METHOD(implicit_rkmk(radau2a2),
               {.name = "rkmk/radau2a2",
                .order = 3,
                .cites = {"hairer1996", "munthekaas1999"},
                .summary = "Munthe-Kaas lift of the Radau IIA method with 2 stages, stiffly accurate",
                .variable_cost = true,
                .form = Form::implicit});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
