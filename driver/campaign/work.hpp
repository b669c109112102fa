// SPDX-License-Identifier: BSD-3-Clause
//
// What the workers of a run do: compute references and cells, and write them down. Internal to the campaign.
#pragma once

#include <atomic>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "driver/campaign/campaign.hpp"
#include "driver/campaign/progress.hpp"
#include "driver/campaign/work_queue.hpp"
#include "records/journal.hpp"
#include "records/reference_store.hpp"
#include "records/trajectory_file.hpp"
#include "support/files.hpp"

namespace kreisel {

using Finished = std::map<std::string, CellRecord>;

/// Runs one cell; an exception becomes its status, except a FileError of `samples`, which may be null.
Outcome run_cell(const PlannedCell& planned, const Engine& engine, const Reference* reference,
                 const std::stop_token& stop, SampleSink* samples);

/// All that the workers share. It outlives run_campaign if a worker has to be abandoned, so it is held by shared_ptr.
class Campaign {
  public:
    Campaign(const Plan& plan, const Engines& engines, std::filesystem::path folder, const RunSettings& settings)
        : plan_(plan),
          engines_(engines),
          folder_(std::move(folder)),
          build_(settings.build),
          store_(folder_, settings.cache, engines.binary128.reference_digest()),
          journal_(journal_file(folder_, shard_name(settings))) {}

    /// Takes over the results of an earlier run, if complete.
    std::size_t reuse(const JournalContents& earlier, const RunSettings& settings);
    void enqueue();
    void work(const std::stop_token& stop);
    void fail(const std::exception_ptr& error);

    Finished finished() const {
        const std::lock_guard lock(mutex_);
        return finished_;
    }
    ProgressState progress() const;
    std::exception_ptr error() const {
        const std::lock_guard lock(mutex_);
        return error_;
    }
    /// Why references could not be kept in the cache; empty if they could.
    std::string cache_complaint() const {
        const std::lock_guard lock(mutex_);
        return cache_complaint_;
    }
    /// From now on nothing is written: the results are being closed.
    void close() {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }

    std::stop_source stop;
    std::atomic<unsigned> working = 0;

  private:
    void compute_reference(const std::string& hash, const std::stop_token& token);
    void compute_cell(const PlannedCell& planned, const std::stop_token& token);
    /// Those of this shard that were run now and have a CPU time.
    std::vector<std::size_t> timed_cells();
    /// The further rounds of their times, all cells in each round, so that a busy moment of the machine meets all
    /// alike. The journal then has a second line of each cell; if stopped it keeps the time of the first round.
    void time_in_turn(const std::stop_token& token);
    void record(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                TrajectoryFile& samples);
    /// Journals that an interrupted cell has left samples, so that they stay until it is done.
    void keep_part(const PlannedCell& planned, TrajectoryFile& samples);
    bool trajectory_is_whole(const CellRecord& cell) const;

    const Plan plan_;
    const Engines engines_;
    const std::filesystem::path folder_;
    const std::string build_;
    const ReferenceStore store_;
    std::vector<std::size_t> mine_;  // the cells of this shard, by index
    WorkQueue queue_;
    mutable std::mutex mutex_;  // guards what follows
    LineAppender journal_;
    Finished finished_;
    std::map<std::string, Reference> references_;
    std::map<std::string, std::string> reference_errors_;
    std::string cache_complaint_;
    std::exception_ptr error_;
    std::size_t total_ = 0, references_total_ = 0;
    double weight_done_ = 0, weight_total_ = 0;
    bool closed_ = false;
};

}  // namespace kreisel
