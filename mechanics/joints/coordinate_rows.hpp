// SPDX-License-Identifier: BSD-3-Clause
//
// The primitive rows of joints (mechanics/parts/joint_type.hpp) that hold coordinates, along an axis and about it: of
// prescribed motion and of what couples them. Sources: mechanics/joints/joint_rows.hpp. Compiled apart, so that the
// others stay as fast.
#pragma once

#include "mechanics/joints/joint_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Adds a row of one of these primitives.
void write_coordinate_row(const JointRow& row, const Joint& joint, const Real& t, const Motion& first,
                          const Motion& second, JointRows& rows);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
