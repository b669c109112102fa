// SPDX-License-Identifier: BSD-3-Clause
//
// Defects of constraints and changes of first integrals.
#include "records/kinds/kind.hpp"

namespace kreisel {

KREISEL_EXPERIMENT(
    {.name = "drift", .summary = "defects and invariants", .metrics = {"defect.*", "invariant.*"}, .figure = "drift"});

}  // namespace kreisel
