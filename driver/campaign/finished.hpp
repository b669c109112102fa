// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of a plan that have a result. What it says stays in the journals, and is read where it is wanted: a plan of
// a million cells would not fit into memory with its results.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "records/journal.hpp"

namespace kreisel {

/// How a cell has ended, as far as counts tell.
enum class CellEnd : std::uint8_t { missing, ok, skipped, failed };

/// What a run keeps in mind of a cell that has ended.
struct CellEnding {
    CellEnd end = CellEnd::missing;
    bool remarkable = false;  ///< something is said of it after the run though it is ok
};
CellEnding ending_of(const CellOutcome& outcome);

/// Cells by their index in the plan.
class FinishedCells {
  public:
    explicit FinishedCells(std::size_t cells) : cells_(cells) {}

    /// A journal that places refer to; returns its number.
    std::uint32_t add_journal(const std::filesystem::path& journal) { return lines_.add(journal); }
    /// What a line of a journal says of a cell. Of several lines the last counts.
    void set(std::size_t index, const CellEnding& ending, const JournalPlace& place);

    std::size_t size() const { return size_; }
    bool has(std::size_t index) const { return end(index) != CellEnd::missing; }
    CellEnd end(std::size_t index) const { return cells_[index].ending.end; }
    bool is_remarkable(std::size_t index) const { return cells_[index].ending.remarkable; }
    /// Throws FileError.
    CellRecord record(std::size_t index) const { return lines_.record(cells_[index].place); }
    std::string line(std::size_t index) const { return lines_.line(cells_[index].place); }

  private:
    struct Finished {
        JournalPlace place;
        CellEnding ending;
    };
    std::vector<Finished> cells_;
    JournalLines lines_;
    std::size_t size_ = 0;
};

}  // namespace kreisel
