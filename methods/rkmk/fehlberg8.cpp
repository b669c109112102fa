// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Fehlberg's 7(8) pair. The solution of order 8 is advanced, by local extrapolation, where Fehlberg
// advances that of order 7. The eleventh of his stages, one of two at the node 1, belongs to the latter only and stands
// last here: the two after it do not use it, and a step without an estimate has twelve stages.
// Sources: [fehlberg1968, Table X], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau fehlberg8{
    .a = {{},
          {{2, 27}},
          {{1, 36}, {1, 12}},
          {{1, 24}, 0, {1, 8}},
          {{5, 12}, 0, {-25, 16}, {25, 16}},
          {{1, 20}, 0, 0, {1, 4}, {1, 5}},
          {{-25, 108}, 0, 0, {125, 108}, {-65, 27}, {125, 54}},
          {{31, 300}, 0, 0, 0, {61, 225}, {-2, 9}, {13, 900}},
          {2, 0, 0, {-53, 6}, {704, 45}, {-107, 9}, {67, 90}, 3},
          {{-91, 108}, 0, 0, {23, 108}, {-976, 135}, {311, 54}, {-19, 60}, {17, 6}, {-1, 12}},
          {{3, 205}, 0, 0, 0, 0, {-6, 41}, {-3, 205}, {-3, 41}, {3, 41}, {6, 41}},
          {{-1777, 4100}, 0, 0, {-341, 164}, {4496, 1025}, {-289, 82}, {2193, 4100}, {51, 82}, {33, 164}, {12, 41}, 1},
          {{2383, 4100}, 0, 0, {-341, 164}, {4496, 1025}, {-301, 82}, {2133, 4100}, {45, 82}, {45, 164}, {18, 41}}},
    .b = {0, 0, 0, 0, 0, {34, 105}, {9, 35}, {9, 35}, {9, 280}, {9, 280}, {41, 840}, {41, 840}, 0},
    .b_hat = {{41, 840}, 0, 0, 0, 0, {34, 105}, {9, 35}, {9, 35}, {9, 280}, {9, 280}, 0, 0, {41, 840}},
    .c = {0, {2, 27}, {1, 9}, {1, 6}, {5, 12}, {1, 2}, {5, 6}, {1, 6}, {2, 3}, {1, 3}, 0, 1, 1},
};

KREISEL_METHOD(rkmk(fehlberg8), {.name = "rkmk/fehlberg8",
                                 .order = 8,
                                 .cites = {"fehlberg1968", "munthekaas1998"},
                                 .summary = "Munthe-Kaas lift of Fehlberg's 7(8) pair; advances order 8",
                                 .estimate = 8});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
