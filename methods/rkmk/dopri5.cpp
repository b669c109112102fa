// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the 5(4) pair of Dormand and Prince with seven stages. The solution of order 5 is advanced; the
// seventh stage lies where the step ends.
// Sources: [dormand1980, Table 2], [hairer1993, Table II.5.2], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau dopri5{
    .a = {{},
          {{1, 5}},
          {{3, 40}, {9, 40}},
          {{44, 45}, {-56, 15}, {32, 9}},
          {{19372, 6561}, {-25360, 2187}, {64448, 6561}, {-212, 729}},
          {{9017, 3168}, {-355, 33}, {46732, 5247}, {49, 176}, {-5103, 18656}},
          {{35, 384}, 0, {500, 1113}, {125, 192}, {-2187, 6784}, {11, 84}}},
    .b = {{35, 384}, 0, {500, 1113}, {125, 192}, {-2187, 6784}, {11, 84}, 0},
    .b_hat = {{5179, 57600}, 0, {7571, 16695}, {393, 640}, {-92097, 339200}, {187, 2100}, {1, 40}},
    .c = {0, {1, 5}, {3, 10}, {4, 5}, {8, 9}, 1, 1},
};

KREISEL_METHOD(rkmk(dopri5), {.name = "rkmk/dopri5",
                              .order = 5,
                              .cites = {"dormand1980", "hairer1993", "munthekaas1998"},
                              .summary = "Munthe-Kaas lift of the 5(4) pair of Dormand and Prince; advances order 5",
                              .estimate = 5});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
