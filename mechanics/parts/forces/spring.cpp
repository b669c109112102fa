// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

namespace kreisel {

KREISEL_FORCE_KEYS({"spring",
                    "stiffness (l - length) + damping l' along the line of two points at distance l",
                    {{"between", ValueKind::names, true},
                     {"points", ValueKind::vectors, true},
                     {"stiffness", ValueKind::not_negative, true},
                     {"damping", ValueKind::not_negative, false},
                     {"length", ValueKind::not_negative, false}}},
                   {.place = 1});

}  // namespace kreisel
