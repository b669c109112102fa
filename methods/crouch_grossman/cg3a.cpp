// SPDX-License-Identifier: BSD-3-Clause
//
// Crouch and Grossman's three-stage method of order 3.
//     0   |
//    3/4  |   3/4
//   17/24 | 119/216  17/108
//   ------+------------------------
//         |  13/51    -2/3   24/17
// Source: [crouchgrossman1993], [hairer2006, Sec. IV.8.1].
#include "methods/crouch_grossman/crouch_grossman.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau cg3a{
    .a = {{}, {{3, 4}}, {{119, 216}, {17, 108}}},
    .b = {{13, 51}, {-2, 3}, {24, 17}},
};

KREISEL_METHOD(crouch_grossman(cg3a), {.name = "crouch_grossman/cg3a",
                                       .order = 3,
                                       .cites = {"crouchgrossman1993", "hairer2006"},
                                       .summary = "Crouch-Grossman method of order 3 with three stages"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
