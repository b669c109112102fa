// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

namespace kreisel {

KREISEL_FORCE_KEYS({"rotational_damper",
                    "torque -damping (omega_second - omega_first) on the second body",
                    {{"between", ValueKind::names, true}, {"damping", ValueKind::not_negative, true}}},
                   {.place = 7, .rigid_only = true});

}  // namespace kreisel
