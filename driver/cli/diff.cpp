// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/diff.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cmath>

#include "plots/diff/tables.hpp"
#include "records/diff/compare_cells.hpp"
#include "records/diff/recorded_folder.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

constexpr std::size_t most_rows = 20;
constexpr const char* beginning_of_differences = "difference,cell in A,cell in B,";  // of the table in full

void print_comparison(const DiffSettings& settings, const CellComparison& comparison, std::ostream& out) {
    fmt::print(out, "A: {}\nB: {}\n", settings.a.string(), settings.b.string());
    fmt::print(out, "{}\n", comparison_summary(comparison));
    if (settings.within) {
        fmt::print(out, "final states and metrics that are no further apart than {} of their scale count as the same\n",
                   *settings.within);
    }
    for (const std::string& note : comparison.notes) { fmt::print(out, "{}\n", note); }
    for (const TextTable& table : difference_tables(comparison, most_rows)) {
        fmt::print(out, "\n{}", terminal_text(table));
    }
}

}  // namespace

Exit diff_command(const DiffSettings& settings, std::ostream& out, std::ostream& messages) {
    if (settings.within && !(*settings.within > 0 && std::isfinite(*settings.within))) {
        throw UsageError(fmt::format("--within: expected a number greater than 0, got {}", *settings.within));
    }
    if (!settings.csv.empty()) { require_own({settings.csv}, settings.csv, beginning_of_differences); }
    const RecordedFolder a = read_recorded_folder(settings.a), b = read_recorded_folder(settings.b);
    for (const RecordedFolder* folder : {&a, &b}) {
        if (!folder->warning.empty()) { fmt::print(messages, "{}\n", folder->warning); }
        for (const std::string& damage : folder->damage) { fmt::print(messages, "{}\n", damage); }
    }
    const CellComparison comparison = compare_cells(a.cells, b.cells, settings.within);
    if (!settings.csv.empty()) { write_atomically(settings.csv, csv_text(differences_in_full(comparison))); }
    print_comparison(settings, comparison, out);
    if (!a.damage.empty() || !b.damage.empty()) { return Exit::io; }
    return comparison.differs() ? Exit::cells_failed : Exit::ok;
}

}  // namespace kreisel
