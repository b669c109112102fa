// SPDX-License-Identifier: BSD-3-Clause
#include "plots/table.hpp"

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <utility>

#include "plots/tables/latex.hpp"
#include "plots/tables/names.hpp"
#include "plots/tables/table.hpp"
#include "records/folder/derived_files.hpp"
#include "records/reading/read_results.hpp"
#include "records/remarks/lost_integrals.hpp"
#include "records/remarks/past_horizon.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

// Columns stated once, above a table, if they are the same in every row.
std::vector<std::string> common_columns() {
    auto columns = CellNames::axes();
    columns.insert(columns.end(), {"steps", "h [s]", "defect", "integral", "status"});
    return columns;
}

// Prints tables and collects them as texts, by their path below the results.
class TableCollector {
  public:
    void add(TablePair table, bool print) {
        if (table.full.rows.empty()) { return; }
        const std::string path = "tables/" + table.full.name;
        texts_[path + ".csv"] = csv_text(table.full);
        TextTable& brief = table.abridged ? *table.abridged : table.full;
        if (table.abridged) { table.full = {}; }
        const TextTable compact = without_constant_columns(std::move(brief), common_columns());
        texts_[path + ".md"] = markdown_text(compact);
        texts_[path + ".tex"] = latex_text(compact);
        if (print) { std::cout << terminal_text(compact) << "\n"; }
    }
    const std::map<std::string, std::string>& texts() const { return texts_; }

  private:
    std::map<std::string, std::string> texts_;
};

void print_counts(const Results& results) {
    std::size_t ok = 0, skipped = 0;
    for (const ResultRow& row : results.rows) {
        ok += row.ok() ? 1U : 0U;
        skipped += row.status == "skipped" ? 1U : 0U;
    }
    const std::string missing = results.missing.empty() ? "" : fmt::format(", {} missing", results.missing.size());
    fmt::print("{}: {} cells: {} ok, {} skipped, {} failed{}\n\n", results.name,
               results.rows.size() + results.missing.size(), ok, skipped, results.rows.size() - ok - skipped, missing);
    auto notes = past_horizon_notes(results.rows);
    for (std::string& note : lost_integral_notes(results.rows)) { notes.push_back(std::move(note)); }
    for (const std::string& note : notes) { fmt::print("{}\n", note); }
    if (!notes.empty()) { fmt::print("\n"); }
}

/// With a word of what is wrong with them.
Results read_aloud(const std::filesystem::path& folder, const PlannedCells& planned) {
    Results results = read_results(folder, planned);
    if (!results.warning.empty()) { std::cerr << results.warning << "\n"; }
    for (const std::string& damage : results.damage) { std::cerr << damage << "\n"; }
    return results;
}

}  // namespace

Exit chosen_table_command(const std::filesystem::path& folder, const TableChoice& choice, const PlannedCells& planned) {
    require_results(folder);
    const FolderLock lock = FolderLock::of_reader(folder);
    const Results results = read_aloud(folder, planned);
    try {
        std::cout << chosen_table(results, choice);
    } catch (const UsageError& error) {
        if (results.damage.empty()) { throw; }
        std::cerr << error.what() << "\n";  // what is damaged may have had it
    }
    return results.damage.empty() ? Exit::ok : Exit::io;
}

Exit table_command(const std::filesystem::path& folder, const PlannedCells& planned) {
    require_results(folder);
    const std::string why_not = why_not_writable(folder);
    const FolderLock lock = why_not.empty() ? FolderLock(folder, "") : FolderLock::of_reader(folder);
    const Results results = read_aloud(folder, planned);
    print_counts(results);
    TableCollector tables;
    for (const ResultTable& table : result_tables()) {
        if (!table.applies(results)) { continue; }
        for (TablePair& pair : table.make(results)) { tables.add(std::move(pair), table.is_printed(results)); }
    }
    if (!why_not.empty()) {
        throw FileError(fmt::format("{}: cannot be written: {}; the tables are printed only",
                                    (folder / "tables").string(), why_not));
    }
    replace_derived(folder, "tables", tables.texts());
    fmt::print("tables in {}\n", (folder / "tables").string());
    return results.damage.empty() ? Exit::ok : Exit::io;
}

}  // namespace kreisel
