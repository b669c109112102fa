// SPDX-License-Identifier: BSD-3-Clause
//
// What methods preserve.
#include "records/kinds/kind.hpp"

namespace kreisel {

KREISEL_EXPERIMENT({.name = "structure",
                    .summary = "what methods preserve: the two-form, reversal, first integrals, constraints",
                    .metrics = {"structure.*", "defect.*", "invariant.*"},
                    .figure = "structure"});

}  // namespace kreisel
