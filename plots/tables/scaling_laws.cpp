// SPDX-License-Identifier: BSD-3-Clause
//
// One row per curve of timed cells: the exponents of time and memory with their errors.
#include <fmt/format.h>

#include "plots/laws/scaling.hpp"
#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"

namespace kreisel {

namespace {

std::vector<std::string> law_cells(const std::optional<ScalingLaw>& law) {
    if (!law) { return {"-", "-"}; }
    return {fmt::format("{:.3f}", law->exponent), fmt::format("{:.3f}", law->error)};
}

TextTable scaling_laws_table(const Results& results) {
    const auto rows = by_series(results.rows);
    const CellNames names(rows);
    TextTable table =
        cell_table("scaling_laws", "Growth with the number of bodies N: " + results.name,
                   {"from N", "to N", "exponent of time", "error", "exponent of memory", "error of memory"});
    table.notes = {fmt::format(
        "Time and memory grow like N^exponent: least squares in log-log from {} bodies on, with the standard error.",
        least_bodies)};
    for (const CellGroup& curve : scaling_curves(rows)) {
        const auto time = scaling_law(curve, "cost.step"), memory = scaling_law(curve, "cost.memory");
        if (!time) { continue; }
        std::vector<std::string> cells = {fmt::format("{}", time->from), fmt::format("{}", time->to)};
        for (const auto& law : {time, memory}) {
            for (std::string& cell : law_cells(law)) { cells.push_back(std::move(cell)); }
        }
        add_row(table, names, curve.front(), cells);
    }
    return table;
}

std::vector<TablePair> scaling_laws_tables(const Results& results) { return one_table(scaling_laws_table(results)); }

}  // namespace

KREISEL_TABLE({.name = "scaling_laws",
               .summary = "exponents of time and memory over the number of bodies",
               .place = 60,
               .applies = has_timed_cells,
               .is_printed = always,
               .make = scaling_laws_tables});

}  // namespace kreisel
