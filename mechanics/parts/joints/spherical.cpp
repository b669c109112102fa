// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT({.name = "spherical",
               .summary = "the points coincide",
               .place = 1,
               .rows = {coincidence()},
               .free = {FreeMotion::turn_about_point}});

}  // namespace kreisel
