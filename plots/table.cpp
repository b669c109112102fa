// SPDX-License-Identifier: BSD-3-Clause
#include "plots/table.hpp"

#include <fmt/format.h>

#include <iostream>

#include "plots/tables/certification.hpp"
#include "plots/tables/drift.hpp"
#include "plots/tables/orders.hpp"
#include "plots/tables/references.hpp"
#include "plots/tables/scaling.hpp"
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

    void write(const TextTable& full, const TextTable& brief, bool print) {
        if (full.rows.empty()) { return; }
        const TextTable compact = without_constant_columns(brief, common_columns());
        write_table(folder_, full, compact);
        if (print) { std::cout << terminal_text(compact) << "\n"; }
    }
    void write(const TextTable& table, bool print) { write(table, table, print); }

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
    TableWriter writer(tables);
    const bool convergence = !error_metrics(results.rows).empty();
    if (convergence) {
        for (const TextTable& table : certification_tables(results)) { writer.write(table, table, false); }
        writer.write(references_table(results), false);
        writer.write(orders_in_full(results), orders_in_brief(results), true);
        writer.write(errors_in_full(results), errors_in_brief(results), true);
    }
    const bool scaling = results.kind == "scaling";
    if (scaling) {
        writer.write(scaling_table(results, exact_number), scaling_table(results, short_number), true);
        writer.write(scaling_laws_table(results), true);
    }
    writer.write(drift_table(results, folder, exact_number), drift_table(results, folder, short_number), !convergence);
    writer.write(invariants_table(results, exact_number), invariants_table(results, short_number), !convergence);
    writer.write(cost_table(results), false);
    writer.write(failures_table(results), true);
    fmt::print("tables in {}\n", tables.string());
    return results.damage.empty() ? Exit::ok : Exit::io;
}

}  // namespace kreisel
