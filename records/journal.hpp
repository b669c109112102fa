// SPDX-License-Identifier: BSD-3-Clause
//
// The journals of an output folder: what has been computed so far, in the order it was finished.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "records/cell/line.hpp"
#include "support/files.hpp"

namespace kreisel {

/// Where a line stands: its journal, by the order of these, and its bytes there.
struct JournalPlace {
    std::uint32_t file = 0, size = 0;
    std::uint64_t begin = 0;
};

/// Lines of journals, read when they are wanted: places take less memory than records. The journal that was read last
/// stays open, the others are closed.
class JournalLines {
  public:
    /// Adds a journal; returns its number.
    std::uint32_t add(const std::filesystem::path& journal);
    /// Both throw FileError, also where the line is not what it was.
    std::string line(const JournalPlace& place) const;
    CellRecord record(const JournalPlace& place) const;

  private:
    std::string text_at(const JournalPlace& place) const;
    [[noreturn]] void fail_changed(const JournalPlace& place) const;

    std::vector<std::filesystem::path> files_;
    mutable std::optional<LineFile> open_ = {};
    mutable std::uint32_t number_ = 0;  // of the open one
};

struct JournalContents {
    std::vector<std::filesystem::path> files = {};   ///< the journals
    std::map<std::string, JournalPlace> cells = {};  ///< by hash; of several lines of one cell the last
    std::set<std::string> foreign = {};              ///< hashes of cells that have only lines of other builds
    std::set<std::string> interrupted = {};          ///< cells that were begun and whose samples so far are kept
    std::vector<std::string> complaints = {};        ///< torn and damaged lines

    /// The journals, to read the cells from.
    JournalLines lines() const;
};

/// `journal.jsonl`, or `journal.<shard>.jsonl`.
std::filesystem::path journal_file(const std::filesystem::path& folder, const std::string& shard);

/// Reads all journals of a folder. Torn and damaged lines, and those of other builds, are reported and ignored. `build`
/// empty: of any build.
/// Throws FileError if a journal cannot be read.
JournalContents read_journals(const std::filesystem::path& folder, const std::string& build);

/// A text for each line whose sum does not hold, and each journal that cannot be read. A torn last line is no damage:
/// whatever kills a run leaves one.
std::vector<std::string> journal_damage(const std::filesystem::path& folder);

/// Removes a torn last line, so that the next one starts on a line of its own.
void mend_journal(const std::filesystem::path& journal);

/// Leaves only intact lines of this build. Nothing may be appending to the journal.
void prune_journal(const std::filesystem::path& journal, const std::string& build);

/// True if the folder holds any journal line.
bool holds_journal(const std::filesystem::path& folder);

/// Journals or manifests of a folder, sorted: `stem<extension>` and `stem.I-of-N<extension>`, and no other names.
std::vector<std::filesystem::path> shard_files(const std::filesystem::path& folder, const std::string& stem,
                                               const std::string& extension);

/// Files of the folder whose name is `stem*.<extension>`, sorted.
std::vector<std::filesystem::path> files_like(const std::filesystem::path& folder, const std::string& stem,
                                              const std::string& extension);

}  // namespace kreisel
