// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT({.name = "screw",
               .summary = "slides along the axis by its lead in each turn about it",
               .place = 5,
               .axes = JointAxes::common,
               .rows = {along(1), along(2), orthogonal(3, 1), orthogonal(3, 2), helix()},
               .free = {FreeMotion::screw}});

}  // namespace kreisel
