// SPDX-License-Identifier: BSD-3-Clause
//
// Errors of the final states of a convergence study.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "plots/laws/convergence.hpp"
#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

// How its steps are given: a tolerance where some cell has one, beside it their number and size.
std::vector<std::string> steps_titles(bool tolerances) {
    return tolerances ? std::vector<std::string>{"steps", "h [s]", "tolerance"}
                      : std::vector<std::string>{"steps", "h [s]"};
}

std::vector<std::string> steps_cells(const ResultRow& row, bool tolerances, std::string (*number)(double)) {
    const double absent = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::string> cells = {row.adaptive() ? number(absent) : fmt::format("{}", row.steps),
                                      number(step_size(row))};
    if (tolerances) { cells.push_back(number(row.adaptive() ? row.tolerance : absent)); }
    return cells;
}

std::vector<std::string> errors_of_row(const ResultRow& row, const std::vector<std::string>& metrics,
                                       std::string (*number)(double)) {
    std::vector<std::string> cells;
    for (const std::string& metric : metrics) { cells.push_back(number(value_or_nan(row.metrics, metric))); }
    return cells;
}

// Marks the errors of a row that ends past the horizon of its reference.
std::vector<std::string> marked(std::vector<std::string> cells, const ResultRow& row) {
    for (std::size_t i = 0; i < cells.size() && row.past_horizon; ++i) { cells[i] += cells[i] == "-" ? "" : "*"; }
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

std::string what_errors(const std::vector<std::string>& metrics) {
    const bool on_the_way = std::any_of(metrics.begin(), metrics.end(), is_largest_error);
    return on_the_way ? "Errors of the final state, and largest of all samples" : "Errors of the final state";
}

// One row per cell: steps, step size and the error of each metric.
TextTable errors_in_full(const Results& results) {
    const CellNames names(results.rows);
    const auto metrics = error_metrics(results.rows);
    const bool tolerances = has_adaptive_cells(results);
    TextTable table{"errors", what_errors(metrics) + ": " + results.name, {}, {}};
    table.columns = with(with(CellNames::axes(), steps_titles(tolerances)),
                         with(with_units(metrics, results.units), {"past_horizon"}));
    for (const CellGroup& group : group_by_method(results.rows)) {
        for (const ResultRow* row : group.rows) {
            if (!row->ok()) { continue; }
            table.rows.push_back(with(with(identity(names, *row), steps_cells(*row, tolerances, exact_number)),
                                      errors_of_row(*row, metrics, exact_number)));
            table.rows.back().emplace_back(row->past_horizon ? "yes" : "");
        }
    }
    return table;
}

// The finest cell of each group.
TextTable errors_in_brief(const Results& results) {
    const CellNames names(results.rows);
    const auto metrics = error_metrics(results.rows);
    TextTable table{"errors", what_errors(metrics) + ", finest step: " + results.name, {}, {}};
    const bool tolerances = has_adaptive_cells(results);
    bool past = false;
    table.columns = with(with(CellNames::axes(), steps_titles(tolerances)), with_units(metrics, results.units));
    for (const CellGroup& group : group_by_method(results.rows)) {
        const ResultRow* best = finest(group);
        if (best == nullptr) { continue; }
        table.rows.push_back(with(with(identity(names, *best), steps_cells(*best, tolerances, short_number)),
                                  marked(errors_of_row(*best, metrics, short_number), *best)));
        past = past || best->past_horizon;
    }
    if (past) {
        table.notes.emplace_back(
            "An asterisk marks errors past the horizon of the reference: they are above 100 times its uncertainty.");
    }
    return without_constant_columns(table, with(CellNames::axes(), steps_titles(tolerances)));
}

std::vector<TablePair> errors_tables(const Results& results) {
    return one_table(errors_in_full(results), errors_in_brief(results));
}

}  // namespace

KREISEL_TABLE({.name = "errors",
               .summary = "errors of the final state: each cell, and the finest of each group",
               .place = 40,
               .applies = has_errors,
               .is_printed = always,
               .repeats_cells = true,
               .make = errors_tables});

}  // namespace kreisel
