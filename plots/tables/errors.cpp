// SPDX-License-Identifier: BSD-3-Clause
//
// Errors of the final states of a convergence study.
#include <fmt/format.h>

#include "plots/laws/convergence.hpp"
#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"

namespace kreisel {

namespace {

std::vector<std::string> errors_row(const ResultRow& row, const std::vector<std::string>& metrics,
                                    std::string (*number)(double)) {
    std::vector<std::string> cells = {fmt::format("{}", row.steps), number(row.h)};
    for (const std::string& metric : metrics) { cells.push_back(number(value_or_nan(row.metrics, metric))); }
    return cells;
}

// Marks the errors of a row that ends past the horizon of its reference; the first two cells are not errors.
std::vector<std::string> marked(std::vector<std::string> cells, const ResultRow& row) {
    for (std::size_t i = 2; i < cells.size() && row.past_horizon; ++i) { cells[i] += cells[i] == "-" ? "" : "*"; }
    return cells;
}

std::vector<std::string> with_units(const std::vector<std::string>& metrics, const Units& units) {
    std::vector<std::string> titles;
    titles.reserve(metrics.size());
    for (const std::string& metric : metrics) {
        titles.push_back(fmt::format("{} [{}]", metric, metric_unit(metric, units)));
    }
    return titles;
}

// One row per cell: steps, step size and the error of each metric.
TextTable errors_in_full(const Results& results) {
    const CellNames names(results.rows);
    const auto metrics = error_metrics(results.rows);
    TextTable table{"errors", "Errors of the final state: " + results.name, {}, {}};
    table.columns =
        with(with(with(CellNames::axes(), {"steps", "h [s]"}), with_units(metrics, results.units)), {"past_horizon"});
    for (const CellGroup& group : group_by_method(results.rows)) {
        for (const ResultRow* row : group.rows) {
            if (!row->ok()) { continue; }
            table.rows.push_back(with(identity(names, *row), errors_row(*row, metrics, exact_number)));
            table.rows.back().emplace_back(row->past_horizon ? "yes" : "");
        }
    }
    return table;
}

// The finest cell of each group.
TextTable errors_in_brief(const Results& results) {
    const CellNames names(results.rows);
    const auto metrics = error_metrics(results.rows);
    TextTable table{"errors", "Errors of the final state, finest step: " + results.name, {}, {}};
    bool past = false;
    table.columns = with(with(CellNames::axes(), {"steps", "h [s]"}), with_units(metrics, results.units));
    for (const CellGroup& group : group_by_method(results.rows)) {
        const ResultRow* best = finest(group);
        if (best == nullptr) { continue; }
        table.rows.push_back(with(identity(names, *best), marked(errors_row(*best, metrics, short_number), *best)));
        past = past || best->past_horizon;
    }
    if (past) {
        table.notes.emplace_back(
            "An asterisk marks errors past the horizon of the reference: they are above 100 times its uncertainty.");
    }
    return without_constant_columns(table, with(CellNames::axes(), {"steps", "h [s]"}));
}

std::vector<TablePair> errors_tables(const Results& results, const std::filesystem::path& /*folder*/) {
    return {{errors_in_full(results), errors_in_brief(results)}};
}

}  // namespace

KREISEL_TABLE({.name = "errors",
               .summary = "errors of the final state: each cell, and the finest of each group",
               .place = 40,
               .applies = has_errors,
               .is_printed = always,
               .make = errors_tables});

}  // namespace kreisel
