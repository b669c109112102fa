// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/table.hpp"

#include <algorithm>
#include <utility>

#include "plots/laws/convergence.hpp"
#include "support/registered.hpp"

namespace kreisel {

std::vector<TablePair> one_table(TextTable full, std::optional<TextTable> abridged) {
    std::vector<TablePair> tables;
    tables.push_back({std::move(full), std::move(abridged)});
    return tables;
}

bool always(const Results& /*results*/) { return true; }

bool never(const Results& /*results*/) { return false; }

bool has_errors(const Results& results) { return !error_metrics(results.rows).empty(); }

bool has_no_errors(const Results& results) { return !has_errors(results); }

bool has_structures(const Results& results) {
    return std::any_of(results.rows.begin(), results.rows.end(), [](const ResultRow& row) {
        return std::any_of(row.metrics.begin(), row.metrics.end(),
                           [](const auto& metric) { return metric.first.starts_with("structure."); });
    });
}

bool has_adaptive_cells(const Results& results) {
    return std::any_of(results.rows.begin(), results.rows.end(), [](const ResultRow& row) { return row.adaptive(); });
}

bool has_timed_cells(const Results& results) {
    return std::any_of(results.rows.begin(), results.rows.end(), [](const ResultRow& row) { return row.bodies > 0; });
}

TableRegistration::TableRegistration(ResultTable table) { Registered<ResultTable>::add(std::move(table)); }

const std::vector<ResultTable>& result_tables() { return Registered<ResultTable>::all(); }

}  // namespace kreisel
