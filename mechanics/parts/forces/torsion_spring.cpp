// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

namespace kreisel {

KREISEL_FORCE_KEYS(
    {"torsion_spring",
     "torque -stiffness (theta - angle) - damping theta' on the second body about an axis both share; theta "
     "counts full turns, and starts at 2 pi turns",
     {{"between", ValueKind::names, true},
      {"axis", ValueKind::vector, true},
      {"stiffness", ValueKind::not_negative, true},
      {"damping", ValueKind::not_negative, false},
      {"angle", ValueKind::number, false},
      {"turns", ValueKind::whole, false}}},
    {.place = 2, .rigid_only = true});

}  // namespace kreisel
