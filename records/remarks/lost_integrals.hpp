// SPDX-License-Identifier: BSD-3-Clause
//
// What `run` and `table` say of cells that have ended well and yet are far from a first integral.
#pragma once

#include <string>
#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// A sentence for each problem (by label) of which a cell has lost more than 1 % of a first integral: how many have, and
/// the one that is farthest off. Cells that did not come to their end are not counted.
std::vector<std::string> lost_integral_notes(const std::vector<ResultRow>& rows);

}  // namespace kreisel
