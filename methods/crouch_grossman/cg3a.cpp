// SPDX-License-Identifier: BSD-3-Clause
//
// Crouch and Grossman's three-stage method of order 3, and a solution of order 2 on the same stages.
//     0   |
//    3/4  |   3/4
//   17/24 | 119/216  17/108
//   ------+------------------------
//     b   |  13/51    -2/3   24/17
//     b^  |  17/54   19/54    1/3
// Source: [crouchgrossman1993], [hairer2006, Sec. IV.8.1], pair [owrenmarthinsen1999, Table 6.1].
#include "methods/crouch_grossman/crouch_grossman.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau cg3a{
    .a = {{}, {{3, 4}}, {{119, 216}, {17, 108}}},
    .b = {{13, 51}, {-2, 3}, {24, 17}},
    .b_hat = {{17, 54}, {19, 54}, {1, 3}},
};

KREISEL_METHOD(crouch_grossman(cg3a), {.name = "crouch_grossman/cg3a",
                                       .order = 3,
                                       .cites = {"crouchgrossman1993", "owrenmarthinsen1999", "hairer2006"},
                                       .summary = "Crouch-Grossman method of order 3 with three stages; pair 3(2)",
                                       .estimate = 3});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
