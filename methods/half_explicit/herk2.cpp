// SPDX-License-Identifier: BSD-3-Clause
//
// Two stages, order 2; Heun's rule as a half-explicit method with an explicit first stage [arnold1998]. Multipliers are
// the mean of both stages, which damps what they alternate by, and have order 1.
//   0 |
//   1 |  1
//   --+---------
//   1 | 1/2 1/2      d = (1/2, 1/2)
#include "methods/half_explicit/half_explicit.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const HalfExplicitScheme herk2{
    .a = {{1}, {{1, 2}, {1, 2}}},
    .result = 3,
    .d = {{1, 2}, {1, 2}},
};

KREISEL_METHOD(half_explicit(herk2), {.name = "half_explicit/herk2",
                                      .order = {2, 2, 1},
                                      .cites = {"braseyhairer1993", "arnold1998", "munthekaas1998"},
                                      .summary = "half-explicit Runge-Kutta method of order 2 for velocity constraints",
                                      .variable_cost = true,
                                      .form = Form::half_explicit,
                                      .reports_multipliers = true,
                                      .meets_velocities = true,
                                      .keeps_memory = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
