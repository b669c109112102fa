// SPDX-License-Identifier: BSD-3-Clause
//
// Three stages, order 3, as a half-explicit method with an explicit first stage [arnold1998]; multipliers have order 2.
//    0  |
//   1/2 | 1/2
//   2/3 | 2/9 4/9
//   ----+-------------
//    1  | 1/4  0  3/4      d = (0, -2, 3)
#include "methods/half_explicit/half_explicit.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const HalfExplicitScheme herk3{
    .a = {{{1, 2}}, {{2, 9}, {4, 9}}, {{1, 4}, 0, {3, 4}}},
    .result = 4,
    .d = {0, -2, 3},
};

KREISEL_METHOD(half_explicit(herk3), {.name = "half_explicit/herk3",
                                      .order = {3, 3, 2},
                                      .cites = {"braseyhairer1993", "arnold1998", "munthekaas1998"},
                                      .summary = "half-explicit Runge-Kutta method of order 3 for velocity constraints",
                                      .variable_cost = true,
                                      .form = Form::half_explicit,
                                      .reports_multipliers = true,
                                      .meets_velocities = true,
                                      .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
