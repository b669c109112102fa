// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting of Runge-Kutta-Nystroem type (methods/splitting/blanes_moan4.cpp), order 6.
// Source: [blanesmoan2002, Table 3, SRKN_11^b], 15 digits. b_1, b_2, a_1 and a_2 are taken as printed; the conditions
// of order 6 determine the rest and are solved by Newton's method from the printed digits.
#include "methods/splitting/splitting.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const SplittingScheme blanes_moan6{
    .kicks = {"0.0414649985182624000000000000000000000000", "0.1981286719180670000000000000000000000000",
              "-0.040006192104156066625526824159612077253142775", "0.075253984301578880740551507627940064673769115",
              "-0.011511387420685777491054796201618256791873659", "0.23666992478693356337603011273329026937124732"},
    .drifts = {"0.1232297759462710000000000000000000000000", "0.2905537977995580000000000000000000000000",
               "-0.12704921262541624504132062371558339320796528", "-0.24633176106209127982765861877193220954014679",
               "0.35720887279594667539679437143486190072369506", "0.20477705429146369894436974210530740404883403"},
};

KREISEL_METHOD(splitting(blanes_moan6), {.name = "splitting/blanes_moan6",
                                         .order = 6,
                                         .cites = {"celledonifasso2008", "blanesmoan2002"},
                                         .summary = "exact free motion between kicks, order 6 of Blanes and Moan",
                                         .force_evaluations = 12,
                                         .preserves = preserved_by_splitting(),
                                         .formulations = formulations_of_splitting});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
