// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

namespace kreisel {

KREISEL_JOINT({.name = "fixed",
               .summary = "nothing moves",
               .place = 7,
               .rows = {coincidence(), orthogonal(3, 1), orthogonal(3, 2), orthogonal(1, 2)}});

}  // namespace kreisel
