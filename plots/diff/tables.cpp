// SPDX-License-Identifier: BSD-3-Clause
#include "plots/diff/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "plots/diff/names.hpp"

namespace kreisel {

namespace {

using Row = std::vector<std::string>;

Row joined_rows(Row first, const Row& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

TextTable one_sided_cells(const CellComparison& comparison) {
    TextTable table{"only", "Cells of one folder only", joined_rows({"only in"}, short_cell_columns()), {}};
    for (const RecordedCell* cell : comparison.only_a) { table.rows.push_back(joined_rows({"A"}, short_cell(*cell))); }
    for (const RecordedCell* cell : comparison.only_b) { table.rows.push_back(joined_rows({"B"}, short_cell(*cell))); }
    return table;
}

TextTable changed_statuses(const CellComparison& comparison) {
    TextTable table{"status", "Cells that changed status", joined_rows(short_cell_columns(), {"in A", "in B"}), {}};
    for (const CellDifference& cell : comparison.changed) {
        if (!cell.status_changed()) { continue; }
        table.rows.push_back(joined_rows(short_cell(*cell.a), {cell.a->status, cell.b->status}));
    }
    return table;
}

/// One family of quantities over all cells: in how many it moved, or is on one side only.
struct FamilyChange {
    std::size_t moved = 0, only_a = 0, only_b = 0;
    double ulps = 0, relative = 0, of_scale = 0;
    const RecordedCell* furthest = nullptr;

    void add(const QuantityDifference& one, const RecordedCell& cell) {
        if (furthest == nullptr || one.of_scale > of_scale) { furthest = &cell; }
        ulps = std::max(ulps, one.ulps);
        relative = std::max(relative, one.relative);
        of_scale = std::max(of_scale, one.of_scale);
    }
};

void count_cell(const CellDifference& cell, std::map<std::string, FamilyChange>& families) {
    struct Seen {
        bool moved = false, only_a = false, only_b = false;
    };
    std::map<std::string, Seen> seen;
    for (const QuantityDifference& one : cell.quantities) {
        Seen& family = seen[one.family];
        (one.b.empty() ? family.only_a : one.a.empty() ? family.only_b : family.moved) = true;
        families[one.family].add(one, *cell.a);
    }
    for (const auto& [name, family] : seen) {
        families[name].moved += family.moved ? 1U : 0U;
        families[name].only_a += family.only_a ? 1U : 0U;
        families[name].only_b += family.only_b ? 1U : 0U;
    }
}

TextTable moved_quantities(const CellComparison& comparison) {
    std::map<std::string, FamilyChange> families;
    for (const CellDifference& cell : comparison.changed) { count_cell(cell, families); }
    TextTable table{"quantities",
                    "Quantities that moved: in how many cells, by how much at most, and where furthest",
                    {"quantity", "moved", "A only", "B only", "ulp", "relative", "of scale", "cell"},
                    {}};
    for (const auto& [name, family] : families) {
        table.rows.push_back({name, fmt::format("{}", family.moved), fmt::format("{}", family.only_a),
                              fmt::format("{}", family.only_b), ulp_text(family.ulps), number_or_dash(family.relative),
                              number_or_dash(family.of_scale), family.furthest->cell});
    }
    return table;
}

TextTable moved_cells(const CellComparison& comparison) {
    std::vector<const CellDifference*> cells;
    for (const CellDifference& cell : comparison.changed) {
        if (!cell.status_changed()) { cells.push_back(&cell); }
    }
    const auto reach = [](const CellDifference* cell) {
        const QuantityDifference* furthest = cell->furthest();
        return furthest == nullptr ? 0 : furthest->of_scale;
    };
    std::stable_sort(cells.begin(), cells.end(), [&](auto* one, auto* two) { return reach(one) > reach(two); });
    TextTable table{
        "cells",
        "Cells that moved, furthest first, with the number that moved furthest by its scale",
        joined_rows(short_cell_columns(), {"differences", "furthest", "in A", "in B", "ulp", "relative", "of scale"}),
        {}};
    for (const CellDifference* cell : cells) {
        const QuantityDifference* furthest = cell->furthest();
        const QuantityDifference& shown = furthest == nullptr ? cell->quantities.front() : *furthest;
        table.rows.push_back(joined_rows(
            short_cell(*cell->a),
            {fmt::format("{}", cell->quantities.size()), shown.name, text_or_dash(shown.a), text_or_dash(shown.b),
             ulp_text(shown.ulps), number_or_dash(shown.relative), number_or_dash(shown.of_scale)}));
    }
    return table;
}

Row full_row(const CellDifference& cell, const QuantityDifference& one) {
    const std::string sort = one.b.empty() ? "number only in A" : one.a.empty() ? "number only in B" : "moved";
    const auto measured = [](double value) { return value > 0 ? exact_number(value) : ""; };
    return joined_rows(joined_rows({sort, cell.a->cell, cell.b->cell}, full_cell(*cell.a)),
                       {one.name, one.a, one.b, measured(one.ulps), measured(one.relative), measured(one.of_scale)});
}

Row status_row(const CellDifference& cell) {
    return joined_rows(joined_rows({"status", cell.a->cell, cell.b->cell}, full_cell(*cell.a)),
                       {"status", cell.a->status, cell.b->status, "", "", ""});
}

}  // namespace

std::string comparison_summary(const CellComparison& comparison) {
    const auto changed =
        static_cast<std::size_t>(std::count_if(comparison.changed.begin(), comparison.changed.end(),
                                               [](const CellDifference& cell) { return cell.status_changed(); }));
    return fmt::format(
        "{} cells in A, {} in B: {} are the same, {} moved, {} changed status, {} in A only, {} in B only",
        comparison.cells_a, comparison.cells_b, comparison.same, comparison.changed.size() - changed, changed,
        comparison.only_a.size(), comparison.only_b.size());
}

std::vector<TextTable> difference_tables(const CellComparison& comparison, std::size_t most) {
    std::vector<TextTable> tables;
    for (TextTable table : {one_sided_cells(comparison), changed_statuses(comparison), moved_quantities(comparison),
                            moved_cells(comparison)}) {
        if (table.rows.empty()) { continue; }
        table = without_constant_columns(table, shared_cell_columns());
        if (table.rows.size() > most && table.name != "quantities") {
            table.notes.push_back(fmt::format("The first {} of {}; --csv FILE writes all.", most, table.rows.size()));
            table.rows.resize(most);
        }
        tables.push_back(std::move(table));
    }
    return tables;
}

TextTable differences_in_full(const CellComparison& comparison) {
    const Row head = joined_rows({"difference", "cell in A", "cell in B"}, full_cell_columns());
    const Row numbers = {"quantity", "in A", "in B", "ulp", "relative", "of scale"};
    TextTable table{"differences", "", joined_rows(head, numbers), {}};
    const Row none(numbers.size());
    for (const RecordedCell* cell : comparison.only_a) {
        table.rows.push_back(joined_rows(joined_rows({"cell only in A", cell->cell, ""}, full_cell(*cell)), none));
    }
    for (const RecordedCell* cell : comparison.only_b) {
        table.rows.push_back(joined_rows(joined_rows({"cell only in B", "", cell->cell}, full_cell(*cell)), none));
    }
    for (const CellDifference& cell : comparison.changed) {
        if (cell.status_changed()) { table.rows.push_back(status_row(cell)); }
        for (const QuantityDifference& one : cell.quantities) { table.rows.push_back(full_row(cell, one)); }
    }
    return table;
}

}  // namespace kreisel
