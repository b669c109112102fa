// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "engine/reference/taylor/row_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A disk that rolls on a plane: one row on its height, two on the velocity of the point in contact.
std::unique_ptr<PointRowSeries> contact_rows(const Joint& joint, const JointEnds& ends);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
