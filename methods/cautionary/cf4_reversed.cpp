// SPDX-License-Identifier: BSD-3-Clause
//
// A trap: commutator_free/cf4 with its factors in the order in which they are printed for Y' = A(Y) Y, although
// q' = q v appends them on the right: order 2, where reversing only the products of its stages would leave 3.
// Source of the scheme: [celledoni2003cf].
#include "methods/commutator_free/commutator_free.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const CommutatorFreeScheme cf4_reversed{
    .stages = {{}, {.factors = {{{1, 2}}}}, {.factors = {{0, {1, 2}}}}, {.factors = {{{-1, 2}, 0, 1}, {{1, 2}}}}},
    .result = {.factors = {{{-1, 12}, {1, 6}, {1, 6}, {1, 4}}, {{1, 4}, {1, 6}, {1, 6}, {-1, 12}}}},
};

KREISEL_METHOD(commutator_free(cf4_reversed),
               {.name = "cautionary/cf4_reversed",
                .order = 2,
                .cites = {"celledoni2003cf"},
                .summary = "WRONG on purpose: commutator_free/cf4 with its factors reversed: order 2"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
