// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/judges/methods/checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Classical fourth-order steps in these coordinates of rotations.
Objection quaternion_step_objection(const Method&);
Objection matrix_step_objection(const Method&);
Objection euler_angles_step_objection(const Method&);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
