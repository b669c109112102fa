// SPDX-License-Identifier: BSD-3-Clause
//
// A trap: the classical fourth-order method whose stages and step go along exp of the combined slopes, as a routine
// `integrate(q, h v)` invites, without dexpinv or any bracket:
//   y_i = y_n exp(h sum_j a_ij K_j),   y_{n+1} = y_n exp(h sum_j b_j K_j).
// General engines ship it as RK4 (MuJoCo's [todorov2012] is one). Lifting a tableau without dexpinv and integrating its
// stages on the manifold are the same thing. Order 4 where all rotations share an axis, order 2 elsewhere
// [hairer2006, Sec. IV.8.2].
#include "methods/rkmk/few_commutators.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const FewCommutatorsScheme rk4_without_dexpinv{
    .stages = {{}, {.weights = {{1, 2}}}, {.weights = {0, {1, 2}}}, {.weights = {0, 0, 1}}},
    .result = {.weights = {{1, 6}, {1, 3}, {1, 3}, {1, 6}}},
};

KREISEL_METHOD(few_commutators(rk4_without_dexpinv),
               {.name = "cautionary/rk4_without_dexpinv",
                .order = 2,
                .cites = {"kutta1901", "todorov2012", "hairer2006"},
                .summary = "WRONG on purpose: fourth-order tableau, stages integrated without dexpinv: order 2"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
