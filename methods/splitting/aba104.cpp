// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting for small kicks, forces that change the motion little: errors of a step O(eps h^11 + eps^2 h^5)
// where forces are of size eps, order 4 in all. It begins and ends with a drift.
// Source: [blanes2013, ABA104], 40 digits. a_1 is taken as printed; Newton's method solves the order conditions,
// consistency, five of the quadrature in eps and one in eps^2, from the rest.
#include "methods/splitting/splitting.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const SplittingScheme aba104{
    .kicks = {0, "0.1188819173681970199453503950853885936956831559", "0.2410504605515015657441667865901651105675524215",
              "-0.2732866667053238060543113981664559460590569558", "0.8267085775712504407295884329818044835916427566"},
    .drifts = {"0.0470671006459725061294788763724367855656400000", "0.1847569354170881069247376193702560968574512776",
               "0.2827060056798362053243616565541452479162970610", "-0.0145300417428968183785781522968381303393883385"},
};

KREISEL_METHOD(splitting(aba104), {.name = "splitting/aba104",
                                   .order = 4,
                                   .cites = {"celledonifasso2008", "blanes2013"},
                                   .summary = "exact free motion between kicks, order 4, 10 in small kicks",
                                   .force_evaluations = 7,
                                   .preserves = preserved_by_splitting(),
                                   .formulations = formulations_of_splitting});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
