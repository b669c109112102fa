// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "engine/reference/taylor/row_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// (z_1 psi_1 + z_2 psi_2) / z_2 of wheels that mesh, up to a constant.
std::unique_ptr<DirectionRowSeries> mesh_row(const Joint& joint, const JointEnds& ends);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
