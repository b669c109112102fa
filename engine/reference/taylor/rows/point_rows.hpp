// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "engine/reference/taylor/row_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// d = 0.
std::unique_ptr<PointRowSeries> coincidence_rows(const JointEnds& ends);
/// b . d = 0 for axes b of the second body, b_3 . d + f = 0 for a prescribed shift.
std::unique_ptr<PointRowSeries> along_rows(const Joint& joint, const JointEnds& ends);
/// |d| = L(t).
std::unique_ptr<PointRowSeries> distance_row(const Joint& joint, const JointEnds& ends);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
