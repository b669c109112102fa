// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/table.hpp"

#include <algorithm>

#include "plots/laws/convergence.hpp"

namespace kreisel {

namespace {

std::vector<ResultTable>& registered_tables() {
    static std::vector<ResultTable> all;
    return all;
}

}  // namespace

TablePair unabridged(const TextTable& table) { return {table, table}; }

bool always(const Results& /*results*/) { return true; }

bool never(const Results& /*results*/) { return false; }

bool has_errors(const Results& results) { return !error_metrics(results.rows).empty(); }

bool has_no_errors(const Results& results) { return !has_errors(results); }

bool has_timed_cells(const Results& results) {
    return std::any_of(results.rows.begin(), results.rows.end(), [](const ResultRow& row) { return row.bodies > 0; });
}

TableRegistration::TableRegistration(ResultTable table) { registered_tables().push_back(std::move(table)); }

const std::vector<ResultTable>& result_tables() {
    static const std::vector<ResultTable> sorted = [] {
        auto all = registered_tables();
        std::sort(all.begin(), all.end(), [](const ResultTable& a, const ResultTable& b) { return a.place < b.place; });
        return all;
    }();
    return sorted;
}

}  // namespace kreisel
