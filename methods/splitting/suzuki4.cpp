// SPDX-License-Identifier: BSD-3-Clause
//
// Five steps of splitting/strang, of gamma h, gamma h, (1 - 4 gamma) h, gamma h, gamma h with gamma = 1/(4 - 4^(1/3)).
// Source: [suzuki1990]; [hairer2006, Ex. II.4.3].
#include "methods/splitting/splitting.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static const SplittingScheme suzuki4{
    .kicks = {"0.20724538589718786857117703143038074785588730", "0.41449077179437573714235406286076149571177460",
              "-0.12173615769156360571353109429114224356766191"},
    .drifts = {"0.41449077179437573714235406286076149571177460", "0.41449077179437573714235406286076149571177460",
               "-0.65796308717750294856941625144304598284709842"},
};

KREISEL_METHOD(splitting(suzuki4), {.name = "splitting/suzuki4",
                                    .order = 4,
                                    .cites = {"celledonifasso2008", "suzuki1990", "hairer2006"},
                                    .summary = "exact free motion between kicks, Suzuki's composition of order 4",
                                    .force_evaluations = 6,
                                    .preserves = preserved_by_splitting(),
                                    .formulations = formulations_of_splitting});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
