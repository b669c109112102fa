// SPDX-License-Identifier: BSD-3-Clause
//
// Errors against what they cost.
#include "records/kinds/kind.hpp"

namespace kreisel {

KREISEL_EXPERIMENT({.name = "work_precision",
                    .summary = "errors against their cost: CPU time, solves of the dynamics, and other counts",
                    .metrics = {"error.*", "defect.*", "invariant.*"},
                    .repeated = true,
                    .figure = "work_precision"});

}  // namespace kreisel
