// SPDX-License-Identifier: BSD-3-Clause
//
// Tables whose rows begin with the identity of a cell.
#pragma once

#include "plots/tables/names.hpp"
#include "plots/tables/text.hpp"

namespace kreisel {

/// The names of a cell in the columns problem, formulation, method, projection, precision.
std::vector<std::string> identity(const CellNames& names, const ResultRow& row);

/// An empty table: the columns of the identity, then `columns`.
TextTable cell_table(std::string name, std::string title, const std::vector<std::string>& columns);

/// Adds the row of a cell.
void add_row(TextTable& table, const CellNames& names, const ResultRow& row, const std::vector<std::string>& cells);

/// `head` and `tail` in one list.
std::vector<std::string> with(std::vector<std::string> head, const std::vector<std::string>& tail);

/// The metrics with this prefix ("defect.", "invariant.") and no further suffix, in the order of first appearance.
std::vector<std::string> plain_metrics(const std::vector<ResultRow>& rows, const std::string& prefix);

/// The steps of a cell in a table: "1000", or "to 1e-06".
std::string steps_cell(const ResultRow& row);
/// Their size, s; NaN where they are not of one size.
double step_size(const ResultRow& row);

/// The value of a metric or of a cost; NaN where it is absent.
double value_or_nan(const NamedNumbers& values, const std::string& name);

}  // namespace kreisel
