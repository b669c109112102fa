// SPDX-License-Identifier: BSD-3-Clause
//
// Commutator-free method of order 2 with one exponential in the step, on Heun's nodes:
//   y_2 = y exp(h K_1),   y+ = y exp(h (K_1 + K_2)/2).
// Up to order 2, and no further, combinations of slopes need neither brackets nor products.
// Source: [celledoni2003cf], nodes [heun1900].
#include "methods/commutator_free/commutator_free.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const CommutatorFreeScheme cf2{
    .stages = {{}, {.factors = {{1}}}},
    .result = {.factors = {{{1, 2}, {1, 2}}}},
};

KREISEL_METHOD(commutator_free(cf2), {.name = "commutator_free/cf2",
                                      .order = 2,
                                      .cites = {"celledoni2003cf", "heun1900"},
                                      .summary = "commutator-free method of order 2, two exponentials"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
