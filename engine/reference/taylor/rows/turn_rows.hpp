// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "engine/reference/taylor/row_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// f(t) - theta = 0 of a prescribed turn.
std::unique_ptr<DirectionRowSeries> prescribed_turn_row(const Joint& joint, const JointEnds& ends);
/// f - theta = 0 of a screw, f = -2 pi b_3 . d / lead.
std::unique_ptr<DirectionRowSeries> helix_row(const Joint& joint, const JointEnds& ends);
/// f - theta = 0 of a pinion on a rack, f = 2 pi a_3 . d / lead, theta counted in the plane of a_3 and -a_2.
std::unique_ptr<DirectionRowSeries> rack_row(const Joint& joint, const JointEnds& ends);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
