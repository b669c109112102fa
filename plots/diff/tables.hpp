// SPDX-License-Identifier: BSD-3-Clause
//
// A comparison of two results folders as tables.
#pragma once

#include <string>
#include <vector>

#include "plots/tables/text.hpp"
#include "records/diff/compare_cells.hpp"

namespace kreisel {

/// "24 cells in A, 23 in B: 20 are the same, 2 moved, 1 changed status, 1 in A only, 0 in B only".
std::string comparison_summary(const CellComparison& comparison);

/// For a terminal: cells of one folder only, cells that changed status, quantities that moved (a row each, with
/// the cell in which it moved furthest), cells that moved (furthest first). At most `most` cells; a note
/// gives their number. Tables without rows are left out.
std::vector<TextTable> difference_tables(const CellComparison& comparison, std::size_t most);

/// Every difference, a row each: its kind, the cell's hash in A and B and what it ran, and for numbers both
/// and their distance.
TextTable differences_in_full(const CellComparison& comparison);

}  // namespace kreisel
