// SPDX-License-Identifier: BSD-3-Clause
//
// One row per timed cell: time per step, and per body; memory, and per body.
#include <fmt/format.h>

#include "plots/laws/scaling.hpp"
#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"

namespace kreisel {

namespace {

TextTable scaling_table(const Results& results, std::string (*number)(double)) {
    const auto rows = by_series(results.rows);
    const CellNames names(rows);
    TextTable table =
        cell_table("scaling", "Time and memory: " + results.name,
                   {"steps", "bodies", "per step [s]", "per step and body [s]", "memory [bytes]", "per body [bytes]"});
    table.notes = {
        "CPU time of a step: the mean of the runs of the fastest of five rounds, divided by their steps. Memory: what "
        "model, system, method, projection and state occupy on the heap; differences of a few kB are noise. Both "
        "depend "
        "on the machine, the time also on its load."};
    for (const ResultRow& row : rows) {
        if (!row.ok()) { continue; }
        std::vector<std::string> cells = {fmt::format("{}", row.steps), fmt::format("{}", row.bodies)};
        for (const ScalingQuantity& quantity : scaling_quantities()) {
            const auto value = scaling_value(row, quantity.name);
            cells.push_back(value ? number(*value) : "-");
        }
        add_row(table, names, row, cells);
    }
    return table;
}

std::vector<TablePair> scaling_tables(const Results& results) {
    return one_table(scaling_table(results, exact_number), scaling_table(results, short_number));
}

}  // namespace

KREISEL_TABLE({.name = "scaling",
               .summary = "time and memory of a step of each timed cell",
               .place = 50,
               .applies = has_timed_cells,
               .is_printed = always,
               .make = scaling_tables});

}  // namespace kreisel
