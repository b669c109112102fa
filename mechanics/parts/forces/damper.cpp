// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

namespace kreisel {

KREISEL_FORCE_KEYS({"damper",
                    "-damping times the velocity of the second body past the first, at a point of the second",
                    {{"between", ValueKind::names, true},
                     {"point", ValueKind::vector, true},
                     {"damping", ValueKind::not_negative, true}}},
                   {.place = 6});

}  // namespace kreisel
