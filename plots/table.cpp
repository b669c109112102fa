// SPDX-License-Identifier: BSD-3-Clause
#include "plots/table.hpp"

#include <fmt/format.h>

#include <iostream>

#include "plots/tables/names.hpp"
#include "plots/tables/table.hpp"
#include "records/remarks/lost_integrals.hpp"
#include "records/remarks/past_horizon.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

// Columns stated once, above a table, if they are the same in every row.
std::vector<std::string> common_columns() {
    auto columns = CellNames::axes();
    columns.insert(columns.end(), {"steps", "h [s]", "defect", "integral", "status"});
    return columns;
}

class TableWriter {
  public:
    explicit TableWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}

    void write(const TablePair& table, bool print) const {
        if (table.full.rows.empty()) { return; }
        const TextTable compact = without_constant_columns(table.brief, common_columns());
        write_table(folder_, table.full, compact);
        if (print) { std::cout << terminal_text(compact) << "\n"; }
    }

  private:
    std::filesystem::path folder_;
};

void print_counts(const Results& results) {
    std::size_t ok = 0, skipped = 0;
    for (const ResultRow& row : results.rows) {
        ok += row.ok() ? 1U : 0U;
        skipped += row.status == "skipped" ? 1U : 0U;
    }
    fmt::print("{}: {} cells: {} ok, {} skipped, {} failed\n\n", results.name, results.rows.size(), ok, skipped,
               results.rows.size() - ok - skipped);
    auto notes = past_horizon_notes(results.rows);
    for (std::string& note : lost_integral_notes(results.rows)) { notes.push_back(std::move(note)); }
    for (const std::string& note : notes) { fmt::print("{}\n", note); }
    if (!notes.empty()) { fmt::print("\n"); }
}

}  // namespace

Exit table_command(const std::filesystem::path& folder) {
    const Results results = read_results(folder);
    for (const std::string& damage : results.damage) { std::cerr << damage << "\n"; }
    print_counts(results);
    const auto tables = folder / "tables";
    std::filesystem::remove_all(tables);  // tables of an earlier run must not remain beside these
    const TableWriter writer(tables);
    for (const ResultTable& table : result_tables()) {
        if (!table.applies(results)) { continue; }
        for (const TablePair& pair : table.make(results, folder)) { writer.write(pair, table.is_printed(results)); }
    }
    fmt::print("tables in {}\n", tables.string());
    return results.damage.empty() ? Exit::ok : Exit::io;
}

}  // namespace kreisel
