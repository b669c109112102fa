// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the pair of orders 5(4) in the method of Cash and Karp. The solution of order 5 is advanced.
// Sources: [cash1990], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau cash_karp5{
    .a = {{},
          {{1, 5}},
          {{3, 40}, {9, 40}},
          {{3, 10}, {-9, 10}, {6, 5}},
          {{-11, 54}, {5, 2}, {-70, 27}, {35, 27}},
          {{1631, 55296}, {175, 512}, {575, 13824}, {44275, 110592}, {253, 4096}}},
    .b = {{37, 378}, 0, {250, 621}, {125, 594}, 0, {512, 1771}},
    .b_hat = {{2825, 27648}, 0, {18575, 48384}, {13525, 55296}, {277, 14336}, {1, 4}},
    .c = {0, {1, 5}, {3, 10}, {3, 5}, 1, {7, 8}},
};

KREISEL_METHOD(rkmk(cash_karp5), {.name = "rkmk/cash_karp5",
                                  .order = 5,
                                  .cites = {"cash1990", "munthekaas1998"},
                                  .summary = "Munthe-Kaas lift of the 5(4) pair of Cash and Karp; advances order 5",
                                  .estimate = 5});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
