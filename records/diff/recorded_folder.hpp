// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of a results folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "records/diff/recorded_cell.hpp"

namespace kreisel {

struct RecordedFolder {
    std::vector<RecordedCell> cells;  ///< in the order of the file
    std::vector<std::string> damage;  ///< a text for each damaged file, and each line that cannot be read
    std::string warning;              ///< that it is of an older format; empty otherwise
};

/// Reads results.jsonl, or where there is none (a run that was stopped, a shard) all journal*.jsonl, in which the last
/// line of a cell counts, whichever build wrote it. Throws FileError where the folder holds neither, or they cannot be
/// read.
RecordedFolder read_recorded_folder(const std::filesystem::path& folder);

}  // namespace kreisel
