// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the 3(2) pair of Bogacki and Shampine. The solution of order 3 is advanced; the fourth stage lies
// where the step ends. Dense output of order 3: the cubic through both ends with their slopes.
//    0  |
//   1/2 | 1/2
//   3/4 |  0    3/4
//    1  | 2/9   1/3  4/9
//   ----+-----------------------
//    b  | 2/9   1/3  4/9   0
//   b^  | 7/24  1/4  1/3  1/8
// Sources: [bogacki1989], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau bs3{
    .a = {{}, {{1, 2}}, {0, {3, 4}}, {{2, 9}, {1, 3}, {4, 9}}},
    .b = {{2, 9}, {1, 3}, {4, 9}, 0},
    .b_hat = {{7, 24}, {1, 4}, {1, 3}, {1, 8}},
    .c = {0, {1, 2}, {3, 4}, 1},
    .dense = {{1, {-4, 3}, {5, 9}}, {0, 1, {-2, 3}}, {0, {4, 3}, {-8, 9}}, {0, -1, 1}},
};

KREISEL_METHOD(rkmk(bs3), {.name = "rkmk/bs3",
                           .order = 3,
                           .cites = {"bogacki1989", "munthekaas1998"},
                           .summary = "Munthe-Kaas lift of the 3(2) pair of Bogacki and Shampine; advances order 3",
                           .estimate = 3,
                           .dense = 3});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
