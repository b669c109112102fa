// SPDX-License-Identifier: BSD-3-Clause
//
// The classical fourth-order method with the wrong sign of dexpinv (methods/cautionary/right_series.hpp).
#include "methods/cautionary/right_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau rk4_right_series{
    .a = {{}, {{1, 2}}, {0, {1, 2}}, {0, 0, 1}},
    .b = {{1, 6}, {1, 3}, {1, 3}, {1, 6}},
};

KREISEL_METHOD(
    right_series(rk4_right_series),
    {.name = "cautionary/rk4_right_series",
     .order = 2,
     .cites = {"kutta1901", "terzezlatarmueller"},
     .summary = "WRONG on purpose: rkmk/rk4 with the right-trivialised dexpinv on left kinematics: order 2"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
