// SPDX-License-Identifier: BSD-3-Clause
//
// Commutator-free method of order 4 with five exponentials: on a vector space, the classical Runge-Kutta method.
//   y_2 = y exp(h K_1/2),   y_3 = y exp(h K_2/2),   y_4 = y_2 exp(h (K_3 - K_1/2)),
//   y+ = y exp(h (3 K_1 + 2 K_2 + 2 K_3 - K_4)/12) exp(h (-K_1 + 2 K_2 + 2 K_3 + 3 K_4)/12).
// The embedded third order takes one more stage, and is the rule of Bogacki and Shampine on a vector space:
//   y_5 = y exp(3h K_2/4),   y^ = y exp(h K_1/3) exp(h (-K_1 + 3 K_2 + 4 K_5)/9).
// Sources: [celledoni2003cf], pair [curryowren2019]; there all products stand in reverse.
#include "methods/commutator_free/commutator_free.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const CommutatorFreeScheme cf4{
    .stages = {{},
               {.factors = {{{1, 2}}}},
               {.factors = {{0, {1, 2}}}},
               {.from = 2, .factors = {{{-1, 2}, 0, 1}}},
               {.factors = {{0, {3, 4}}}}},
    .result = {.factors = {{{1, 4}, {1, 6}, {1, 6}, {-1, 12}}, {{-1, 12}, {1, 6}, {1, 6}, {1, 4}}}},
    .embedded = {.factors = {{{1, 3}}, {{-1, 9}, {1, 3}, 0, 0, {4, 9}}}},
};

KREISEL_METHOD(commutator_free(cf4), {.name = "commutator_free/cf4",
                                      .order = 4,
                                      .cites = {"celledoni2003cf", "curryowren2019"},
                                      .summary = "commutator-free method of order 4, five exponentials; pair 4(3)",
                                      .estimate = 4});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
