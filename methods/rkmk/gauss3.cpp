// SPDX-License-Identifier: BSD-3-Clause
#include "methods/rkmk/gauss.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_METHOD(gauss(3), {.name = "rkmk/gauss3",
                          .order = 6,
                          .cites = {"hairer2006", "munthekaas1998", "zanna2001"},
                          .summary = "Munthe-Kaas lift of the Gauss method with 3 stages, symmetric",
                          .variable_cost = true,
                          .form = Form::implicit,
                          .preserves = {{Property::symmetric, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
