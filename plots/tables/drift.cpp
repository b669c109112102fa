// SPDX-License-Identifier: BSD-3-Clause
//
// One row per cell and defect: maximum, final value, growth exponent with its spread and the fitted range.
#include <fmt/format.h>

#include "plots/laws/growth.hpp"
#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

std::vector<std::string> growth_cells(const std::optional<GrowthLaw>& growth) {
    if (!growth) { return {"-", "-", "-"}; }
    return {fmt::format("{:.2f}", growth->exponent), fmt::format("{:.2f}", growth->spread),
            fmt::format("{:.4g}–{:.4g}", growth->from, growth->to)};
}

TextTable drift_table(const Results& results, std::string (*number)(double)) {
    const CellNames names(results.rows);
    TextTable table = cell_table("drift", "Constraint and orthogonality defects: " + results.name,
                                 {"steps", "h [s]", "defect", "maximum", "final", "exponent", "spread", "range [s]"});
    table.notes = {
        "Growth law: the running maximum of the defect grows like t^exponent over the given range of t (least squares "
        "in log-log over the last two octaves); spread: largest distance of an octave's own exponent from it. None is "
        "given for round-off, or where the octaves differ by more than 1/2."};
    const auto metrics = plain_metrics(results.rows, "defect.");
    for (const ResultRow& row : results.rows) {
        if (row.status == "skipped") { continue; }
        const auto trajectory = row.has_trajectory ? read_trajectory(row) : TrajectoryTable{};
        for (const std::string& name : metrics) {
            if (!row.metrics.contains(name)) { continue; }
            std::vector<std::string> cells = {steps_cell(row), number(step_size(row)), name.substr(7),
                                              number(value_or_nan(row.metrics, name)),
                                              number(value_or_nan(row.metrics, name + ".final"))};
            for (std::string& cell : growth_cells(growth_of(trajectory, name, row.precision))) {
                cells.push_back(std::move(cell));
            }
            add_row(table, names, row, cells);
        }
    }
    return table;
}

std::vector<TablePair> drift_tables(const Results& results) {
    return one_table(drift_table(results, exact_number), drift_table(results, short_number));
}

}  // namespace

KREISEL_TABLE({.name = "drift",
               .summary = "defects of constraints and orthogonality, with their growth laws",
               .place = 70,
               .applies = always,
               .is_printed = has_no_errors,
               .make = drift_tables});

}  // namespace kreisel
