// SPDX-License-Identifier: BSD-3-Clause
//
// One row per cell and first integral: maximum, relative maximum, secular slope with its standard error.
#include <fmt/format.h>

#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"

namespace kreisel {

namespace {

TextTable invariants_table(const Results& results, std::string (*number)(double)) {
    const CellNames names(results.rows);
    TextTable table = cell_table("invariants", "First integrals: " + results.name,
                                 {"steps", "h [s]", "integral", "maximum", "relative", "slope [1/s]", "slope error"});
    table.notes = {
        "Largest |I - I0| and |I - I0|/|I0| over all steps; slope: least-squares secular rate of I - I0, in the "
        "unit of the integral per second, with its standard error."};
    for (const ResultRow& row : results.rows) {
        if (row.status == "skipped") { continue; }
        for (const std::string& name : plain_metrics({row}, "invariant.")) {
            add_row(table, names, row,
                    {steps_cell(row), number(step_size(row)), name.substr(10), number(value_or_nan(row.metrics, name)),
                     number(value_or_nan(row.metrics, name + ".relative")),
                     number(value_or_nan(row.metrics, name + ".slope")),
                     number(value_or_nan(row.metrics, name + ".slope_error"))});
        }
    }
    return table;
}

std::vector<TablePair> invariants_tables(const Results& results) {
    return one_table(invariants_table(results, exact_number), invariants_table(results, short_number));
}

}  // namespace

KREISEL_TABLE({.name = "invariants",
               .summary = "largest change and secular rate of each first integral",
               .place = 80,
               .applies = always,
               .is_printed = has_no_errors,
               .repeats_cells = true,
               .make = invariants_tables});

}  // namespace kreisel
