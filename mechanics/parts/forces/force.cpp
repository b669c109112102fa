// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

namespace kreisel {

KREISEL_FORCE_KEYS({"force",
                    "value (1 + amplitude sin(frequency t)) at a point",
                    {{"body", ValueKind::name, true},
                     {"value", ValueKind::vector, true},
                     {"frame", ValueKind::frame, false},
                     {"point", ValueKind::vector, false},
                     {"amplitude", ValueKind::number, false},
                     {"frequency", ValueKind::number, false}}},
                   {.place = 3});

}  // namespace kreisel
