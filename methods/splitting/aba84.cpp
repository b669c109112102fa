// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting for small kicks, forces that change the motion little: errors of a step O(eps h^9 + eps^2 h^5)
// where forces are of size eps, order 4 in all. It begins and ends with a drift.
// Source: [mclachlan1995, order (8, 4)], 20 digits, from which Newton's method solves the order conditions:
// consistency, four of the quadrature in eps, one in eps^2.
#include "methods/splitting/splitting.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const SplittingScheme aba84{
    .kicks = {0, "0.1902259393736766192452307627384538974612036199", "0.8465240704435262570550805446467758341771137424",
              "-1.0735000196344057526006226147704594632766347246"},
    .drifts = {"0.0753469602698928884165278036834744643726526646", "0.5179168546882567823007739784963156443238474478",
               "-0.0932638149581496707173017821797901086965001124"},
};

KREISEL_METHOD(splitting(aba84), {.name = "splitting/aba84",
                                  .order = 4,
                                  .cites = {"celledonifasso2008", "mclachlan1995"},
                                  .summary = "exact free motion between kicks, order 4, 8 in small kicks",
                                  .force_evaluations = 5,
                                  .preserves = preserved_by_splitting(),
                                  .formulations = formulations_of_splitting});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
