// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT({.name = "cylindrical",
               .summary = "turns about the axis and slides along it",
               .place = 5,
               .axes = JointAxes::common,
               .rows = {along(1), along(2), orthogonal(3, 1), orthogonal(3, 2)},
               .free = {FreeMotion::turn_about_axis, FreeMotion::slide_along_axis}});

}  // namespace kreisel
