// SPDX-License-Identifier: BSD-3-Clause
//
// Observed tolerance proportionality of cells whose steps are chosen to tolerances: slopes, never orders.
#include "plots/laws/proportionality.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plots/laws/convergence.hpp"
#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"

namespace kreisel {

namespace {

const std::vector<std::string> proportionality_notes = {
    "Observed tolerance proportionality: least-squares slope of log error against log tolerance over the tolerances in "
    "brackets, +- its standard error. Admissible errors lie below 1e-2 of the scale, above 100 times the error of the "
    "reference and above 100 eps sqrt(N) of the scale, from N >= 20 steps; at least four over three decades, none "
    "further than a factor of 10 from the line. With local extrapolation a slope of 1 is expected."};

std::vector<std::string> slope_in_full(const Proportionality& law) {
    if (!law.slope) { return {"", "", "", "", law.reason}; }
    return {fmt::format("{:.4f}", *law.slope), fmt::format("{:.4f}", law.uncertainty), exact_number(law.from),
            exact_number(law.to), ""};
}

std::string slope_cell(const Proportionality& law) {
    if (!law.slope) { return law.points.empty() ? "-" : "none"; }
    return fmt::format("{:.2f} ± {:.2f} [{}–{}]", *law.slope, law.uncertainty, law.from, law.to);
}

// One row per group and metric, with the reason where there is no slope.
TextTable proportionality_in_full(const Results& results) {
    const CellNames names(results.rows);
    TextTable table = cell_table(
        "proportionality", "Observed tolerance proportionality: " + results.name,
        {"controller", "metric", "proportionality", "uncertainty", "first_tolerance", "last_tolerance", "remark"});
    for (const CellGroup& group : group_by_method(results.rows)) {
        if (!is_adaptive(group)) { continue; }
        for (const std::string& metric : error_metrics(results.rows)) {
            const Proportionality law = proportionality_of(group, metric);
            if (law.points.empty()) { continue; }
            add_row(table, names, group.front(), with({group.front().controller, metric}, slope_in_full(law)));
        }
    }
    return table;
}

// One row per group, one column per metric.
TextTable proportionality_in_brief(const Results& results) {
    const CellNames names(results.rows);
    const auto metrics = error_metrics(results.rows);
    std::vector<std::string> columns = {"controller"};
    for (const std::string& metric : metrics) { columns.push_back(metric.substr(metric.find('.') + 1)); }
    TextTable table = cell_table("proportionality", "Observed tolerance proportionality: " + results.name, columns);
    table.notes = proportionality_notes;
    for (const CellGroup& group : group_by_method(results.rows)) {
        if (!is_adaptive(group)) { continue; }
        std::vector<std::string> cells = {group.front().controller};
        for (const std::string& metric : metrics) { cells.push_back(slope_cell(proportionality_of(group, metric))); }
        const bool any = std::any_of(cells.begin() + 1, cells.end(), [](const auto& cell) { return cell != "-"; });
        if (any) { add_row(table, names, group.front(), cells); }
    }
    return without_constant_columns(table, with(CellNames::axes(), {"controller"}));
}

std::vector<TablePair> proportionality_tables(const Results& results) {
    return one_table(proportionality_in_full(results), proportionality_in_brief(results));
}

}  // namespace

KREISEL_TABLE({.name = "proportionality",
               .summary = "observed tolerance proportionality of steps chosen to tolerances",
               .place = 35,
               .applies = has_adaptive_cells,
               .is_printed = always,
               .make = proportionality_tables});

}  // namespace kreisel
