// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT({.name = "planar",
               .summary = "moves in the plane through the points, normal to the axis",
               .place = 6,
               .axes = JointAxes::common,
               .rows = {along(3), orthogonal(3, 1), orthogonal(3, 2)},
               .free = {FreeMotion::turn_about_normal, FreeMotion::slide_across_axis}});

}  // namespace kreisel
