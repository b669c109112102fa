// SPDX-License-Identifier: BSD-3-Clause
//
// One row per cell: solves of the dynamics and projection iterations, in all and per step (of those accepted).
#include <fmt/format.h>

#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"

namespace kreisel {

namespace {

TextTable cost_table(const Results& results) {
    const CellNames names(results.rows);
    TextTable table = cell_table("cost", "Cost: " + results.name,
                                 {"steps", "evaluations", "per step", "projection iterations", "iterations per step"});
    table.notes = {
        "Evaluations are solves of the dynamics inside the steps; those of start, projection and output are "
        "counted apart."};
    for (const ResultRow& row : results.rows) {
        if (!row.ok() || !row.cost.contains("evaluations")) { continue; }
        const double evaluations = row.cost.at("evaluations");
        const auto found = row.cost.find("projection_iterations");
        const double iterations = found == row.cost.end() ? 0 : found->second;
        const double steps = row.adaptive() ? value_or_nan(row.cost, "accepted") : static_cast<double>(row.steps);
        add_row(table, names, row,
                {fmt::format("{}", steps), fmt::format("{}", evaluations), fmt::format("{:.3g}", evaluations / steps),
                 fmt::format("{}", iterations), fmt::format("{:.3g}", iterations / steps)});
    }
    return table;
}

std::vector<TablePair> cost_tables(const Results& results) { return one_table(cost_table(results)); }

}  // namespace

KREISEL_TABLE({.name = "cost",
               .summary = "solves of the dynamics and projection iterations of each cell",
               .place = 90,
               .applies = always,
               .is_printed = never,
               .repeats_cells = true,
               .make = cost_tables});

}  // namespace kreisel
