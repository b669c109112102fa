// SPDX-License-Identifier: BSD-3-Clause
#include "records/diff/recorded_folder.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <stdexcept>

#include "records/folder/damage.hpp"
#include "records/journal.hpp"
#include "records/manifest.hpp"
#include "records/sums/sum_list.hpp"
#include "records/sums/summed_text.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

/// Reads a file whose lines must have sums if its format is `known`; returns how many it has.
std::size_t read_cells(const std::filesystem::path& file, bool known, bool each_once, RecordedFolder& result) {
    const auto lines = read_lines(file);
    std::set<std::string> seen;
    const bool summed = lines_have_sums(lines, known);
    if (!summed) { result.warning = format_warning(file.parent_path()); }
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].empty()) { continue; }
        try {
            require_sum(lines[i], summed);
            RecordedCell cell = read_recorded_cell(lines[i]);
            if (each_once && !seen.insert(cell.cell).second) { throw std::invalid_argument(repeated_cell); }
            result.cells.push_back(std::move(cell));
        } catch (const std::exception& error) {
            result.damage.push_back(fmt::format("{}:{}: not a result line: {}", file.string(), i + 1, error.what()));
        }
    }
    return lines.size();
}

void note_damaged_samples(const std::filesystem::path& folder, RecordedFolder& result) {
    for (const RecordedCell& cell : result.cells) {
        if (cell.trajectory_sum.empty() || !is_cell_name(cell.cell)) { continue; }
        std::string damage = trajectory_damage(folder, cell.cell, cell.trajectory_sum);
        if (!damage.empty()) { result.damage.push_back(std::move(damage)); }
    }
}

/// What results.jsonl lacks at its end.
void note_missing_lines(const std::filesystem::path& folder, std::size_t lines, RecordedFolder& result) {
    const auto file = manifest_file(folder, "");
    if (!is_taken(file)) { return; }
    try {
        std::string missing = missing_lines(folder / "results.jsonl", lines, read_manifest(file));
        if (!missing.empty()) { result.damage.push_back(std::move(missing)); }
    } catch (const FileError&) {  // folder_damage says so
        return;
    } catch (const UsageError&) { return; }
}

/// Of several lines about one cell the last one stays.
void drop_older_lines(std::vector<RecordedCell>& cells) {
    std::map<std::string, std::size_t> last;
    for (std::size_t i = 0; i < cells.size(); ++i) { last[cells[i].cell] = i; }
    std::vector<RecordedCell> kept;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (last.at(cells[i].cell) == i) { kept.push_back(std::move(cells[i])); }
    }
    cells = std::move(kept);
}

}  // namespace

RecordedFolder read_recorded_folder(const std::filesystem::path& folder) {
    RecordedFolder result;
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error)) {
        throw FileError(fmt::format("{}: there is no such folder", folder.string()));
    }
    const bool known = format_of(folder) >= folder_format;
    const bool finished = std::filesystem::exists(folder / "results.jsonl", error);
    result.damage = finished ? folder_damage(folder) : run_damage(folder);
    if (finished) {
        note_missing_lines(folder, read_cells(folder / "results.jsonl", known, true, result), result);
        note_damaged_samples(folder, result);
        return result;
    }
    // results.csv is written after it.
    if (read_sum_list(folder).has("results.csv")) {
        result.damage.push_back(fmt::format("{}: damaged: it is not there", (folder / "results.jsonl").string()));
    }
    const auto journals = shard_files(folder, "journal", ".jsonl");
    if (journals.empty()) {
        throw FileError(
            fmt::format("{}: expected a folder that kreisel run has written, got one without results.jsonl "
                        "and journal",
                        folder.string()));
    }
    for (const auto& file : journals) { read_cells(file, true, false, result); }  // their lines have always had sums
    std::erase_if(result.cells, [](const RecordedCell& cell) { return cell.status == status::interrupted; });
    drop_older_lines(result.cells);
    note_damaged_samples(folder, result);
    return result;
}

}  // namespace kreisel
