// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
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

std::vector<std::string> with(std::vector<std::string> head, const std::vector<std::string>& tail) {
    head.insert(head.end(), tail.begin(), tail.end());
    return head;
}

std::vector<std::string> plain_metrics(const std::vector<ResultRow>& rows, const std::string& prefix) {
    std::vector<std::string> found;
    for (const ResultRow& row : rows) {
        for (const auto& [name, value] : row.metrics) {
            const bool plain = name.starts_with(prefix) && name.find('.', prefix.size()) == std::string::npos;
            if (plain && std::find(found.begin(), found.end(), name) == found.end()) { found.push_back(name); }
        }
    }
    return found;
}

std::string steps_cell(const ResultRow& row) {
    return row.adaptive() ? fmt::format("to {}", row.tolerance) : fmt::format("{}", row.steps);
}

double step_size(const ResultRow& row) { return row.adaptive() ? std::numeric_limits<double>::quiet_NaN() : row.h; }

double value_or_nan(const NamedNumbers& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

}  // namespace kreisel
