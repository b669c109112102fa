// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting of Runge-Kutta-Nystroem type, order 4 with small error: kicks change v by what depends only on q and the
// free motion is quadratic in v, so that [B, [B, [B, A]]] = 0, on a group too.
// Source: [blanesmoan2002, Table 3, SRKN_6^b], 15 digits. b_1, b_2 and a_1 are taken as printed; the conditions of
// order 4 determine the rest and are solved by Newton's method from the printed digits.
#include "methods/splitting/splitting.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const SplittingScheme blanes_moan4{
    .kicks = {"0.0829844064174052000000000000000000000000", "0.3963098014983680000000000000000000000000",
              "-0.039056304922345844779619677270012315621652493", "0.11952419401314528955923935454002463124330499"},
    .drifts = {"0.2452989571842710000000000000000000000000", "0.60487266571109442310932851278210607471495279",
               "-0.35017162289536542310932851278210607471495279"},
};

KREISEL_METHOD(splitting(blanes_moan4), {.name = "splitting/blanes_moan4",
                                         .order = 4,
                                         .cites = {"celledonifasso2008", "blanesmoan2002"},
                                         .summary = "exact free motion between kicks, order 4 of Blanes and Moan",
                                         .force_evaluations = 7,
                                         .preserves = preserved_by_splitting(),
                                         .formulations = formulations_of_splitting});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
