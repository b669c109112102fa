// SPDX-License-Identifier: BSD-3-Clause
#include "records/diff/recorded_folder.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <stdexcept>

#include "records/cell/line.hpp"
#include "records/journal.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

void read_lines(const std::filesystem::path& file, bool journal, RecordedFolder& result) {
    std::istringstream lines(read_text(file));
    long number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.empty()) { continue; }
        try {
            if (journal && !journalled_cell(line)) { throw std::invalid_argument("its check sum does not hold"); }
            result.cells.push_back(read_recorded_cell(line));
        } catch (const std::exception& error) {
            result.damage.push_back(fmt::format("{}:{}: not a result line: {}", file.string(), number, error.what()));
        }
    }
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
    if (std::error_code error; !std::filesystem::is_directory(folder, error)) {
        throw FileError(fmt::format("{}: there is no such folder", folder.string()));
    }
    if (std::filesystem::exists(folder / "results.jsonl")) {
        read_lines(folder / "results.jsonl", false, result);
        return result;
    }
    const auto journals = files_like(folder, "journal", ".jsonl");
    if (journals.empty()) {
        throw FileError(
            fmt::format("{}: expected a folder that kreisel run has written, got one without results.jsonl "
                        "and journal",
                        folder.string()));
    }
    for (const auto& file : journals) { read_lines(file, true, result); }
    drop_older_lines(result.cells);
    return result;
}

}  // namespace kreisel
