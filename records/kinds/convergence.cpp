// SPDX-License-Identifier: BSD-3-Clause
//
// Errors over step sizes.
#include "records/kinds/kind.hpp"

namespace kreisel {

KREISEL_EXPERIMENT({.name = "convergence",
                    .summary = "errors over step sizes",
                    .metrics = {"error.*", "defect.*", "invariant.*"},
                    .figure = "convergence"});

}  // namespace kreisel
