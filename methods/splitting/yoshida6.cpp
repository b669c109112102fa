// SPDX-License-Identifier: BSD-3-Clause
//
// Seven steps of splitting/strang, of w_3 h, w_2 h, w_1 h, (1 - 2 (w_1 + w_2 + w_3)) h, w_1 h, w_2 h, w_3 h: solution A
// of [yoshida1990, Table 1], whose digits beyond the printed ones follow from the three conditions of order 6.
// (drifts: w_3, w_2, w_1, ...; kicks: halves of sums of neighbours)
#include "methods/splitting/splitting.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const SplittingScheme yoshida6{
    .kicks = {"0.39225680523877863190974881693317493788841221", "0.51004341191845769875214540842244223873164625",
              "-0.47105338540975643663081124899289056647640059", "0.068753168252520105968917023637273389856342127"},
    .drifts = {"0.78451361047755726381949763386634987577682442", "0.23557321335935813368479318297853460168646808",
               "-1.1776799841788710069464156809643157346392693", "1.3151863206839112188842497282388625143519535"},
};

KREISEL_METHOD(splitting(yoshida6), {.name = "splitting/yoshida6",
                                     .order = 6,
                                     .cites = {"celledonifasso2008", "yoshida1990"},
                                     .summary = "exact free motion between kicks, Yoshida's composition of order 6",
                                     .force_evaluations = 8,
                                     .preserves = preserved_by_splitting(),
                                     .formulations = formulations_of_splitting});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
