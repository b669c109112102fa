// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT({.name = "prismatic",
               .summary = "slides along the axis",
               .place = 4,
               .axes = JointAxes::common,
               .rows = {along(1), along(2), orthogonal(3, 1), orthogonal(3, 2), orthogonal(1, 2)},
               .free = {FreeMotion::slide_along_axis}});

}  // namespace kreisel
