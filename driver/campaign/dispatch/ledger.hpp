// SPDX-License-Identifier: BSD-3-Clause
//
// What a run knows of its cells, and the journal that says it. Internal to the campaign.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "driver/campaign/campaign.hpp"
#include "driver/campaign/finished.hpp"
#include "driver/campaign/progress.hpp"
#include "records/journal.hpp"
#include "support/files.hpp"

namespace kreisel {

class Ledger {
  public:
    Ledger(const Plan& plan, std::filesystem::path folder, const RunSettings& settings);

    /// Takes over the results of an earlier run, if complete; returns how many.
    std::size_t reuse(const JournalContents& earlier, const RunSettings& settings);
    /// What is wrong with samples of earlier cells, which are then not taken over.
    const std::vector<std::string>& damage() const { return damage_; }
    /// The cells of this shard that are to be computed, by index.
    const std::vector<std::size_t>& mine() const { return mine_; }

    /// Writes down a cell that a worker has run: how it ended, and its line of the journal. Throws std::logic_error if
    /// that is of another cell.
    void record(std::size_t index, const CellEnding& ending, const std::string& line);
    /// The same of one that no worker can report; its samples, if there are any, are removed.
    void record(std::size_t index, const Outcome& outcome);
    /// Writes down that an interrupted cell has left samples, so that they stay until it is done.
    void record_part(const std::string& line) { journal_.append(line); }

    /// The cells run now that have a CPU time.
    std::vector<std::size_t> timed_cells();
    /// A further round of such a cell. Nothing: it has none.
    void note_seconds(std::size_t index, std::optional<double> run_s);
    /// A second journal line of each timed cell, with the fastest of its rounds.
    void record_times(const std::vector<std::size_t>& cells);

    const FinishedCells& finished() const { return finished_; }
    ProgressState progress;

  private:
    bool take_over(std::size_t index, const CellRecord& cell, const JournalPlace& place);
    void append(std::size_t index, const CellEnding& ending, const std::string& line);
    void keep(std::size_t index, const CellEnding& ending, const std::string& line);
    bool samples_hold(const CellRecord& cell);

    const Plan& plan_;
    const std::filesystem::path folder_;
    const std::string build_;
    LineAppender journal_;
    std::vector<std::size_t> mine_;
    std::vector<std::string> damage_ = {};
    FinishedCells finished_;
    const std::uint32_t number_;                // of the journal
    std::map<std::size_t, double> run_s_ = {};  // of the cells whose time is taken: the fastest of their rounds
};

}  // namespace kreisel
