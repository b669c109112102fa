// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

namespace kreisel {

KREISEL_FORCE_KEYS({"polynomial_spring",
                    "c_1 s + c_2 s^2 + ... + damping l' along the line of two points at distance l, s = l - length",
                    {{"between", ValueKind::names, true},
                     {"points", ValueKind::vectors, true},
                     {"coefficients", ValueKind::numbers, true},
                     {"damping", ValueKind::not_negative, false},
                     {"length", ValueKind::not_negative, false}}},
                   {.place = 5});

}  // namespace kreisel
