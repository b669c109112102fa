// SPDX-License-Identifier: BSD-3-Clause
//
// Matches the cells of one results folder with those of another.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "records/diff/recorded_cell.hpp"

namespace kreisel {

/// Cells of A and B by their place in each.
struct CellMatching {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;  ///< in the order of A
    std::vector<std::size_t> only_a, only_b;
    std::vector<std::string>
        notes;  ///< pairs matched although one line has more members than the other; a sentence each
};

/// Two cells are the same if their lines agree on what was run (RecordedCell::identity); labels and hashes do
/// not count, but among several such cells those with equal labels match. The rest is matched if one line
/// has all members of the other and additional parameters or options (which an older version did not have), and only
/// one cell of either side qualifies.
CellMatching match_cells(const std::vector<RecordedCell>& a, const std::vector<RecordedCell>& b);

}  // namespace kreisel
