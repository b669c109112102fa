// SPDX-License-Identifier: BSD-3-Clause
//
// What `run` and `table` say of cells that end past the horizon of their reference.
#pragma once

#include <string>
#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// A sentence for each problem (by label) and end time past the horizon: the cells, T*, and what is known of the reference
/// there. Cells that did not come to their end are not counted.
std::vector<std::string> past_horizon_notes(const std::vector<ResultRow>& rows);

}  // namespace kreisel
