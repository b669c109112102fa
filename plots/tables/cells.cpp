// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/cells.hpp"

#include <limits>

namespace kreisel {

std::vector<std::string> identity(const CellNames& names, const ResultRow& row) {
    std::vector<std::string> cells;
    for (const std::string& axis : CellNames::axes()) { cells.push_back(names.axis(row, axis)); }
    return cells;
}

TextTable cell_table(std::string name, std::string title, const std::vector<std::string>& columns) {
    TextTable table{std::move(name), std::move(title), CellNames::axes(), {}};
    table.columns.insert(table.columns.end(), columns.begin(), columns.end());
    return table;
}

void add_row(TextTable& table, const CellNames& names, const ResultRow& row, const std::vector<std::string>& cells) {
    auto line = identity(names, row);
    line.insert(line.end(), cells.begin(), cells.end());
    table.rows.push_back(std::move(line));
}

double value_or_nan(const std::map<std::string, double>& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

}  // namespace kreisel
