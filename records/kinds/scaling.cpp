// SPDX-License-Identifier: BSD-3-Clause
//
// Time and memory of a step against the number of bodies.
#include "records/kinds/kind.hpp"

namespace kreisel {

KREISEL_EXPERIMENT({.name = "scaling",
                    .summary = "time and memory of a step against the number of bodies",
                    .metrics = {},
                    .timed = true,
                    .figure = "scaling"});

}  // namespace kreisel
