// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT({.name = "revolute",
               .summary = "turns about the axis",
               .place = 2,
               .axes = JointAxes::common,
               .rows = {coincidence(), orthogonal(3, 1), orthogonal(3, 2)},
               .free = {FreeMotion::turn_about_axis}});

}  // namespace kreisel
