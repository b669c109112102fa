// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT({.name = "distance",
               .summary = "the points keep a distance of length (1 + amplitude sin(frequency t))",
               .place = 8,
               .rows = {distance()},
               .free = {FreeMotion::turn_about_point, FreeMotion::swing}});

}  // namespace kreisel
