// SPDX-License-Identifier: BSD-3-Clause
#include "plots/report/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "plots/tables/names.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

using PageColumn = ColumnTable::Column;
using TextOfRow = std::function<std::string(const ResultRow&)>;

PageColumn page_column(std::string title, const std::vector<ResultRow>& rows, bool is_text, const TextOfRow& text) {
    PageColumn column{std::move(title), {}, is_text};
    for (const ResultRow& row : rows) { column.texts.push_back(text(row)); }
    return column;
}

// Errors, defects and structure as the catalogue lists them, then integrals.
std::vector<std::string> measured(const std::vector<ResultRow>& rows) {
    std::set<std::string> names;
    for (const ResultRow& row : rows) {
        for (const auto& [name, value] : row.metrics) { names.insert(name); }
    }
    std::vector<std::string> all;
    for (const MetricDescription& metric : metric_catalogue()) {
        for (const std::string& name : names_of_metric(metric)) {
            if (names.erase(name) > 0) { all.push_back(name); }
        }
    }
    all.insert(all.end(), names.begin(), names.end());
    return all;
}

std::string metric_text(const ResultRow& row, const std::string& metric) {
    if (const auto digits = row.digits->find(metric); digits != row.digits->end()) { return digits->second; }
    const auto value = row.metrics.find(metric);
    return value == row.metrics.end() ? "" : exact_number(value->second);
}

std::string with_unit(const std::string& name, const std::string& unit) {
    return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

// The unit of a cost; its name without it.
std::string cost_title(const std::string& name) {
    static const std::map<std::string, std::string> titles = {
        {"step_s", "step [s]"}, {"run_s", "run [s]"}, {"memory", "memory [B]"}};
    const auto found = titles.find(name);
    return found == titles.end() ? name : found->second;
}

std::string if_positive(double value) { return value > 0 ? exact_number(value) : ""; }

void add_stepping(const std::vector<ResultRow>& rows, std::vector<PageColumn>& columns) {
    const auto add = [&](const char* title, double (*value)(const ResultRow&)) {
        if (!std::any_of(rows.begin(), rows.end(), [&](const ResultRow& row) { return value(row) > 0; })) { return; }
        columns.push_back(
            page_column(title, rows, false, [value](const ResultRow& row) { return if_positive(value(row)); }));
    };
    add("steps", [](const ResultRow& row) { return static_cast<double>(row.steps); });
    add("h [s]", [](const ResultRow& row) { return row.adaptive() ? 0 : row.h; });
    add("tolerance", [](const ResultRow& row) { return row.tolerance; });
    add("end [s]", [](const ResultRow& row) { return row.t_end; });
    add("reached [s]", [](const ResultRow& row) { return row.t_reached; });
    add("bodies", [](const ResultRow& row) { return static_cast<double>(row.bodies); });
}

void add_measured(const std::vector<ResultRow>& rows, const Units& units, std::vector<PageColumn>& columns) {
    for (const std::string& metric : measured(rows)) {
        columns.push_back(page_column(with_unit(metric, metric_unit(metric, units)), rows, false,
                                      [&](const ResultRow& row) { return metric_text(row, metric); }));
    }
    std::set<std::string> costs;
    for (const ResultRow& row : rows) {
        for (const auto& [name, value] : row.cost) { costs.insert(name); }
    }
    for (const std::string& cost : costs) {
        columns.push_back(page_column(cost_title(cost), rows, false, [&](const ResultRow& row) {
            const auto found = row.cost.find(cost);
            return found == row.cost.end() ? "" : exact_number(found->second);
        }));
    }
}

}  // namespace

std::vector<ResultRow> all_cells(const Results& results) {
    std::vector<ResultRow> rows = results.rows;
    rows.insert(rows.end(), results.missing.begin(), results.missing.end());
    return rows;
}

ColumnTable cell_columns(const std::vector<ResultRow>& rows, const Units& units) {
    const CellNames names(rows);
    ColumnTable table{"cells", "Every cell", {}};
    table.columns.push_back(page_column("status", rows, true, [](const ResultRow& row) { return row.status; }));
    for (const std::string& axis : CellNames::axes()) {
        table.columns.push_back(
            page_column(axis, rows, true, [&](const ResultRow& row) { return names.axis(row, axis); }));
    }
    add_stepping(rows, table.columns);
    add_measured(rows, units, table.columns);
    table.columns.push_back(page_column("reason", rows, true, [](const ResultRow& row) { return row.detail; }));
    return table;
}

}  // namespace kreisel
