// SPDX-License-Identifier: BSD-3-Clause
//
// A trap: the classical fourth-order tableau in products of exponentials of single slopes. Such products have order
// conditions of their own, the first of them at order 3, sum b_i^2 c_i + 2 sum_{i<j} b_i c_i b_j = 1/3, which no one
// has made this tableau satisfy: order 2 [owrenmarthinsen1999].
#include "methods/crouch_grossman/crouch_grossman.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau rk4_products{
    .a = {{}, {{1, 2}}, {0, {1, 2}}, {0, 0, 1}},
    .b = {{1, 6}, {1, 3}, {1, 3}, {1, 6}},
};

KREISEL_METHOD(crouch_grossman(rk4_products),
               {.name = "cautionary/rk4_products",
                .order = 2,
                .cites = {"kutta1901", "owrenmarthinsen1999"},
                .summary = "WRONG on purpose: fourth-order tableau in products of exponentials: order 2"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
