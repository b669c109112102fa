// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the 5(4) pair of Dormand and Prince with seven stages. The solution of order 5 is advanced; the
// seventh stage lies where the step ends. Dense output of order 4 without further stages, b_i(theta) of degree 4.
// Sources: [dormand1980, Table 2], [hairer1993, Table II.5.2], dense output [shampine1986], lift [munthekaas1998].
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
    .dense = {{1, {-8048581381, 2820520608}, {8663915743, 2820520608}, {-12715105075, 11282082432}},
              {},
              {0, {131558114200, 32700410799}, {-68118460800, 10900136933}, {87487479700, 32700410799}},
              {0, {-1754552775, 470086768}, {14199869525, 1410260304}, {-10690763975, 1880347072}},
              {0, {127303824393, 49829197408}, {-318862633887, 49829197408}, {701980252875, 199316789632}},
              {0, {-282668133, 205662961}, {2019193451, 616988883}, {-1453857185, 822651844}},
              {0, {40617522, 29380423}, {-110615467, 29380423}, {69997945, 29380423}}},
};

KREISEL_METHOD(rkmk(dopri5), {.name = "rkmk/dopri5",
                              .order = 5,
                              .cites = {"dormand1980", "hairer1993", "shampine1986", "munthekaas1998"},
                              .summary = "Munthe-Kaas lift of the 5(4) pair of Dormand and Prince; advances order 5",
                              .estimate = 5,
                              .dense = 4});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
