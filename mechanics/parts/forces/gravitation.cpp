// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

namespace kreisel {

KREISEL_FORCE_KEYS({"gravitation",
                    "attraction constant m_1 m_2 / l^2 of two mass centres at distance l",
                    {{"between", ValueKind::names, true}, {"constant", ValueKind::not_negative, true}}},
                   {.place = 9});

}  // namespace kreisel
