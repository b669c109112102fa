// SPDX-License-Identifier: BSD-3-Clause
//
// A trap: rkmk/mk4 with its brackets as they are printed for Y' = A(Y) Y, although q' = q v. Each bracket has the wrong
// sign, and their correction, instead of vanishing from the error, doubles it: order 2. As declared here, for the right
// form, the signs are therefore the opposite of the printed ones.
// Source of the scheme: [munthekaasowren1999].
#include "methods/rkmk/few_commutators.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const FewCommutatorsScheme mk4_right_brackets{
    .stages = {{},
               {.weights = {{1, 2}}},
               {.weights = {0, {1, 2}}, .brackets = {{1, 2, {1, 8}}}},
               {.weights = {0, 0, 1}}},
    .result = {.weights = {{1, 6}, {1, 3}, {1, 3}, {1, 6}}, .brackets = {{1, 4, {1, 12}}}},
};

KREISEL_METHOD(few_commutators(mk4_right_brackets),
               {.name = "cautionary/mk4_right_brackets",
                .order = 2,
                .cites = {"munthekaasowren1999", "kutta1901"},
                .summary = "WRONG on purpose: rkmk/mk4 with brackets of the wrong sign: order 2"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
