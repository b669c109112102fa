// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT(
    {.name = "rack",
     .summary = "the second body, a pinion about its axis, meshes with the first, a rack along its axis, both "
                "held by other joints; the points are one on the rack's pitch line and the pinion's centre",
     .place = 11,
     .axes = JointAxes::perpendicular,
     .rows = {rack()},
     .free = {FreeMotion::mesh}});

}  // namespace kreisel
