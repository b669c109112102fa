// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of the classical fourth-order method with two brackets in place of dexpinv. As printed, for
// Y' = A(Y) Y:
//   u_2 = k_1/2,   u_3 = k_2/2 - [k_1, k_2]/8,   u_4 = k_3,
//   v = (k_1 + 2 k_2 + 2 k_3 + k_4)/6 - [k_1, k_4]/12.
// Source: [munthekaasowren1999].
#include "methods/rkmk/few_commutators.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const FewCommutatorsScheme mk4{
    .stages = {{},
               {.weights = {{1, 2}}},
               {.weights = {0, {1, 2}}, .brackets = {{1, 2, {-1, 8}}}},
               {.weights = {0, 0, 1}}},
    .result = {.weights = {{1, 6}, {1, 3}, {1, 3}, {1, 6}}, .brackets = {{1, 4, {-1, 12}}}},
};

KREISEL_METHOD(few_commutators(mk4),
               {.name = "rkmk/mk4",
                .order = 4,
                .cites = {"munthekaasowren1999", "kutta1901"},
                .summary = "Munthe-Kaas lift of the classical fourth-order method, two brackets"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
