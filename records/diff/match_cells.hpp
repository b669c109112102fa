// SPDX-License-Identifier: BSD-3-Clause
//
// Which cell of one results folder is which cell of another.
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
        notes;  ///< which pairs were made although one line says more than the other; a sentence each
};

/// Two cells are the same if their lines say the same of what was run (RecordedCell::identity); labels and hashes do
/// not count, but of several such cells those with equal labels belong together. What is left is matched where one line
/// tells all that the other one tells, and a parameter or option more (a version that did not have it yet), if only one
/// cell of either side comes into question.
CellMatching match_cells(const std::vector<RecordedCell>& a, const std::vector<RecordedCell>& b);

}  // namespace kreisel
