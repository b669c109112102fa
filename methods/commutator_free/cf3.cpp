// SPDX-License-Identifier: BSD-3-Clause
//
// Commutator-free method of order 3 with three exponentials, and Heun's rule on its nodes as embedded second order:
//   y_2 = y exp(h K_1/3),   y_3 = y exp(2h K_2/3),   y+ = y_2 exp(h (-K_1/12 + 3/4 K_3)),
//   y^ = y exp(h (K_2 + K_3)/2).
// Sources: [celledoni2003cf], pair [curryowren2019]; there all products stand in reverse.
#include "methods/commutator_free/commutator_free.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const CommutatorFreeScheme cf3{
    .stages = {{}, {.factors = {{{1, 3}}}}, {.factors = {{0, {2, 3}}}}},
    .result = {.from = 2, .factors = {{{-1, 12}, 0, {3, 4}}}},
    .embedded = {.factors = {{0, {1, 2}, {1, 2}}}},
};

KREISEL_METHOD(commutator_free(cf3), {.name = "commutator_free/cf3",
                                      .order = 3,
                                      .cites = {"celledoni2003cf", "curryowren2019"},
                                      .summary = "commutator-free method of order 3, three exponentials; pair 3(2)",
                                      .estimate = 3});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
