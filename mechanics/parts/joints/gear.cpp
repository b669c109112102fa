// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT(
    {.name = "gear",
     .summary = "two wheels, held by other joints, mesh by their numbers of teeth; the points are their centres",
     .place = 10,
     .axes = JointAxes::common,
     .rows = {mesh()},
     .free = {FreeMotion::mesh}});

}  // namespace kreisel
