// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Fehlberg's 4(5) pair. The solution of order 4 is advanced, as he proposed it, without local
// extrapolation: the sixth stage, at node 1/2, serves the estimate only.
// Sources: [fehlberg1969, Table III], lift [munthekaas1998].
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const Tableau fehlberg4{
    .a = {{},
          {{1, 4}},
          {{3, 32}, {9, 32}},
          {{1932, 2197}, {-7200, 2197}, {7296, 2197}},
          {{439, 216}, -8, {3680, 513}, {-845, 4104}},
          {{-8, 27}, 2, {-3544, 2565}, {1859, 4104}, {-11, 40}}},
    .b = {{25, 216}, 0, {1408, 2565}, {2197, 4104}, {-1, 5}, 0},
    .b_hat = {{16, 135}, 0, {6656, 12825}, {28561, 56430}, {-9, 50}, {2, 55}},
    .c = {0, {1, 4}, {3, 8}, {12, 13}, 1, {1, 2}},
};

KREISEL_METHOD(rkmk(fehlberg4), {.name = "rkmk/fehlberg4",
                                 .order = 4,
                                 .cites = {"fehlberg1969", "munthekaas1998"},
                                 .summary = "Munthe-Kaas lift of Fehlberg's 4(5) pair; advances order 4",
                                 .estimate = 5});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
