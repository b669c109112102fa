// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

namespace kreisel {

KREISEL_FORCE_KEYS({"torque",
                    "value (1 + amplitude sin(frequency t))",
                    {{"body", ValueKind::name, true},
                     {"value", ValueKind::vector, true},
                     {"frame", ValueKind::frame, false},
                     {"amplitude", ValueKind::number, false},
                     {"frequency", ValueKind::number, false}}},
                   {.place = 4, .rigid_only = true});

}  // namespace kreisel
