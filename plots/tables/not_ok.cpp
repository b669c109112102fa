// SPDX-License-Identifier: BSD-3-Clause
//
// One row per cell that is not ok, with its reason.
#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"

namespace kreisel {

namespace {

TextTable not_ok_table(const Results& results) {
    const CellNames names(results.rows);
    TextTable table = cell_table("not_ok", "Cells failed or skipped: " + results.name, {"steps", "status", "reason"});
    for (const ResultRow& row : results.rows) {
        if (!row.ok()) { add_row(table, names, row, {steps_cell(row), row.status, row.detail}); }
    }
    return table;
}

std::vector<TablePair> not_ok_tables(const Results& results, const std::filesystem::path& /*folder*/) {
    return {unabridged(not_ok_table(results))};
}

}  // namespace

KREISEL_TABLE({.name = "not_ok",
               .summary = "cells failed or skipped, with the reason",
               .place = 100,
               .applies = always,
               .is_printed = always,
               .make = not_ok_tables});

}  // namespace kreisel
