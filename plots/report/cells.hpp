// SPDX-License-Identifier: BSD-3-Clause
//
// Every cell of an experiment with all that was measured of it.
#pragma once

#include <vector>

#include "plots/report/column_table.hpp"
#include "records/results.hpp"

namespace kreisel {

/// All cells: those with a result in the order of the plan, then those that are missing.
std::vector<ResultRow> all_cells(const Results& results);

/// A row a cell: how it ended and why, what was run, metrics in the order of the catalogue, costs.
ColumnTable cell_columns(const std::vector<ResultRow>& rows, const Units& units);

}  // namespace kreisel
