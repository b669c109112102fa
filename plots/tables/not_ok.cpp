// SPDX-License-Identifier: BSD-3-Clause
//
// One row per cell that is not ok, with its reason, and per planned cell without a result.
#include <algorithm>
#include <functional>

#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"

namespace kreisel {

namespace {

TextTable not_ok_table(const Results& results) {
    TextTable table =
        cell_table("not_ok", "Cells failed, skipped or missing: " + results.name, {"steps", "status", "reason"});
    const bool all_ok = std::all_of(results.rows.begin(), results.rows.end(), std::mem_fn(&ResultRow::ok));
    if (all_ok && results.missing.empty()) { return table; }
    std::vector<ResultRow> all = results.rows;
    all.insert(all.end(), results.missing.begin(), results.missing.end());
    const CellNames names(all);
    for (const ResultRow& row : all) {
        if (!row.ok()) { add_row(table, names, row, {steps_cell(row), row.status, row.detail}); }
    }
    return table;
}

std::vector<TablePair> not_ok_tables(const Results& results) { return one_table(not_ok_table(results)); }

}  // namespace

KREISEL_TABLE({.name = "not_ok",
               .summary = "cells failed, skipped or missing, with the reason",
               .place = 100,
               .applies = always,
               .is_printed = always,
               .repeats_cells = true,
               .make = not_ok_tables});

}  // namespace kreisel
