// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT(
    {.name = "rolling",
     .summary =
         "a disk rolls without slip on a plane: between ground and disk, a point of the plane and the disk's centre, "
         "the normal and the disk's axis",
     .place = 9,
     .axes = JointAxes::not_parallel,
     .rows = {contact()},
     .free = {FreeMotion::roll}});

}  // namespace kreisel
