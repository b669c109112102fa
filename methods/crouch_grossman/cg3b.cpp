// SPDX-License-Identifier: BSD-3-Clause
//
// Crouch and Grossman's second three-stage method of order 3.
//     0   |
//   -1/24 |  -1/24
//   17/24 |  161/24   -6
//   ------+------------------------
//         |    1     -2/3    2/3
// Source: [crouchgrossman1993].
#include "methods/crouch_grossman/crouch_grossman.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau cg3b{
    .a = {{}, {{-1, 24}}, {{161, 24}, -6}},
    .b = {1, {-2, 3}, {2, 3}},
};

KREISEL_METHOD(crouch_grossman(cg3b),
               {.name = "crouch_grossman/cg3b",
                .order = 3,
                .cites = {"crouchgrossman1993"},
                .summary = "Crouch-Grossman method of order 3 with three stages, large coefficients"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
