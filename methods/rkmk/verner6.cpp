// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Verner's most robust 6(5) pair with nine stages. The solution of order 6 is advanced; the ninth
// stage lies where the step ends. (The leading error of his most efficient pair of these orders is so small that its
// errors do not follow the tolerance as those of an order 6.)
// Source: [verner2010], as published by Verner on his page of pairs. Lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau verner6{
    .a = {{},
          {{9, 50}},
          {{29, 324}, {25, 324}},
          {{1, 16}, 0, {3, 16}},
          {{79129, 250000}, 0, {-261237, 250000}, {19663, 15625}},
          {{1336883, 4909125}, 0, {-25476, 30875}, {194159, 185250}, {8225, 78546}},
          {{-2459386, 14727375}, 0, {19504, 30875}, {2377474, 13615875}, {-6157250, 5773131}, {902, 735}},
          {{2699, 7410}, 0, {-252, 1235}, {-1393253, 3993990}, {236875, 72618}, {-135, 49}, {15, 22}},
          {{11, 144}, 0, 0, {256, 693}, 0, {125, 504}, {125, 528}, {5, 72}}},
    .b = {{11, 144}, 0, 0, {256, 693}, 0, {125, 504}, {125, 528}, {5, 72}, 0},
    .b_hat = {{28, 477}, 0, 0, {212, 441}, {-312500, 366177}, {2125, 1764}, 0, {-2105, 35532}, {2995, 17766}},
    .c = {0, {9, 50}, {1, 6}, {1, 4}, {53, 100}, {3, 5}, {4, 5}, 1, 1},
};

KREISEL_METHOD(rkmk(verner6), {.name = "rkmk/verner6",
                               .order = 6,
                               .cites = {"verner2010", "munthekaas1998"},
                               .summary = "Munthe-Kaas lift of Verner's most robust 6(5) pair; advances order 6",
                               .estimate = 6});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
