// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT({.name = "universal",
               .summary = "the points coincide, the two axes stay perpendicular",
               .place = 3,
               .axes = JointAxes::perpendicular,
               .rows = {coincidence(), orthogonal(3, 3)},
               .free = {FreeMotion::turn_about_two}});

}  // namespace kreisel
