// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

namespace kreisel {

KREISEL_FORCE_KEYS(
    {"central_field",
     "attraction mu m / l^2 of a mass centre at distance l from a point in space",
     {{"body", ValueKind::name, true}, {"mu", ValueKind::not_negative, true}, {"centre", ValueKind::vector, false}}},
    {.place = 10});

}  // namespace kreisel
