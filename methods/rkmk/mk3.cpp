// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of Kutta's third-order method with one bracket in place of dexpinv. As printed, for Y' = A(Y) Y:
//   u_2 = k_1/2,   u_3 = -k_1 + 2 k_2,   v = (k_1 + 4 k_2 + k_3)/6 - [k_1, k_3]/12.
// Source: [munthekaasowren1999].
#include "methods/rkmk/few_commutators.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const FewCommutatorsScheme mk3{
    .stages = {{}, {.weights = {{1, 2}}}, {.weights = {-1, 2}}},
    .result = {.weights = {{1, 6}, {2, 3}, {1, 6}}, .brackets = {{1, 3, {-1, 12}}}},
};

KREISEL_METHOD(few_commutators(mk3), {.name = "rkmk/mk3",
                                      .order = 3,
                                      .cites = {"munthekaasowren1999", "kutta1901"},
                                      .summary = "Munthe-Kaas lift of Kutta's third-order method, one bracket"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
