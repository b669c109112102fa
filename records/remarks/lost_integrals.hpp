// SPDX-License-Identifier: BSD-3-Clause
//
// Notes of `run` and `table` on cells that succeeded but violate a first integral.
#pragma once

#include <string>
#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// A sentence for each problem (by label) in which a cell has lost more than 1 % of a first integral: the number of
/// cells, and the worst one. Cells that did not finish are not counted.
std::vector<std::string> lost_integral_notes(const std::vector<ResultRow>& rows);

}  // namespace kreisel
