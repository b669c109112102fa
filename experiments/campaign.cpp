// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <ostream>
#include <thread>

#include "experiments/errors.hpp"
#include "experiments/files.hpp"
#include "experiments/hash.hpp"
#include "experiments/interrupt.hpp"
#include "experiments/journal.hpp"
#include "experiments/progress.hpp"
#include "experiments/provenance.hpp"
#include "experiments/reference_store.hpp"
#include "experiments/work_queue.hpp"

namespace kreisel {

namespace {

using Finished = std::map<std::string, FinishedCell>;

// All that the workers share. It outlives run_campaign if a worker has to be left behind, so it is held by shared_ptr.
class Campaign {
  public:
    Campaign(const Plan& plan, const Engines& engines, std::filesystem::path folder, const RunSettings& settings)
        : plan_(plan),
          engines_(engines),
          folder_(std::move(folder)),
          build_(settings.build),
          journal_(journal_file(folder_, shard_name(settings))) {}

    // Takes over what an earlier run left, if it is whole.
    std::size_t reuse(const JournalContents& earlier, const RunSettings& settings);
    void enqueue();
    void work(const std::stop_token& stop);
    void fail(std::exception_ptr error);

    Finished finished() const {
        const std::lock_guard lock(mutex_);
        return finished_;
    }
    ProgressState progress() const;
    std::exception_ptr error() const {
        const std::lock_guard lock(mutex_);
        return error_;
    }
    /// From now on nothing is written: the results are being closed.
    void close() {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }

    std::stop_source stop;
    std::atomic<unsigned> working = 0;

  private:
    void compute_reference(const std::string& hash);
    void compute_cell(const PlannedCell& planned, const std::stop_token& token);
    void record(const PlannedCell& planned, const Outcome& outcome, const Reference* reference);
    bool trajectory_is_whole(const FinishedCell& cell) const;

    const Plan plan_;
    const Engines engines_;
    const std::filesystem::path folder_;
    const std::string build_;
    std::vector<std::size_t> mine_;  // the cells of this shard, by index
    WorkQueue queue_;
    mutable std::mutex mutex_;  // guards what follows
    LineAppender journal_;
    Finished finished_;
    std::map<std::string, Reference> references_;
    std::map<std::string, std::string> reference_errors_;
    std::exception_ptr error_;
    double weight_done_ = 0, weight_total_ = 0;
    bool closed_ = false;
};

bool Campaign::trajectory_is_whole(const FinishedCell& cell) const {
    std::error_code error;
    const auto file = folder_ / trajectory_file(cell.hash);
    return cell.trajectory_sum.empty() ||
           (std::filesystem::is_regular_file(file, error) && hash_text(read_text(file)) == cell.trajectory_sum);
}

// What did not come from the numbers alone is tried again.
bool is_repeatable(const FinishedCell& cell) {
    return cell.status != "exception" && cell.status != "reference_failed" && cell.status != "interrupted";
}

std::size_t Campaign::reuse(const JournalContents& earlier, const RunSettings& settings) {
    std::size_t reused = 0;
    for (std::size_t i = settings.shard - 1; i < plan_.cells.size(); i += settings.shards) {
        const auto found = earlier.cells.find(plan_.cells[i].hash);
        if (found != earlier.cells.end() && is_repeatable(found->second) && trajectory_is_whole(found->second)) {
            finished_.insert(*found);
            ++reused;
        } else {
            mine_.push_back(i);
        }
    }
    return reused;
}

void Campaign::enqueue() {
    std::stable_sort(mine_.begin(), mine_.end(),
                     [this](std::size_t a, std::size_t b) { return plan_.cells[a].weight > plan_.cells[b].weight; });
    std::set<std::string> needed;
    for (const std::size_t index : mine_) {
        const PlannedCell& planned = plan_.cells[index];
        weight_total_ += planned.weight;
        queue_.add_cell(index, planned.reference);
        if (!planned.reference.empty() && needed.insert(planned.reference).second) {
            queue_.add_reference(planned.reference);
        }
    }
}

void Campaign::work(const std::stop_token& token) {
    while (const auto item = queue_.take(token)) {
        if (item->reference.empty()) {
            compute_cell(plan_.cells[item->cell], token);
        } else {
            compute_reference(item->reference);
            queue_.reference_done(item->reference);
        }
    }
}

void Campaign::compute_reference(const std::string& hash) {
    const PlannedReference& planned = plan_.references.at(hash);
    const auto file = reference_file(folder_, hash);
    auto stored = load_reference(file, planned, build_);
    if (!stored) {
        try {
            stored = engines_.binary128.reference(planned.problem, planned.parameters, planned.t_end);
        } catch (const std::exception& error) {
            const std::lock_guard lock(mutex_);
            reference_errors_[hash] = error.what();
            return;
        }
        const std::lock_guard lock(mutex_);
        if (closed_) { return; }
        store_reference(file, planned, *stored, build_);
    }
    const std::lock_guard lock(mutex_);
    references_.insert_or_assign(hash, std::move(*stored));
}

void Campaign::compute_cell(const PlannedCell& planned, const std::stop_token& token) {
    const Reference* reference = nullptr;
    std::string reference_error;
    if (!planned.reference.empty()) {
        const std::lock_guard lock(mutex_);
        const auto found = references_.find(planned.reference);
        reference = found == references_.end() ? nullptr : &found->second;
        reference_error = reference == nullptr ? reference_errors_[planned.reference] : "";
    }
    Outcome outcome;
    if (!planned.skip_reason.empty()) {
        outcome.status = "skipped";
        outcome.detail = planned.skip_reason;
    } else if (reference == nullptr && !planned.reference.empty()) {
        outcome.status = "reference_failed";
        outcome.detail = reference_error;
    } else {
        outcome = run_cell(planned, engines_.of(planned.precision), reference, token);
    }
    if (outcome.status != "interrupted") { record(planned, outcome, reference); }
}

void Campaign::record(const PlannedCell& planned, const Outcome& outcome, const Reference* reference) {
    FinishedCell cell;
    try {
        cell = finished_cell(planned, outcome, reference);
    } catch (const std::logic_error& error) {
        Outcome broken;
        broken.status = "exception";
        broken.detail = error.what();
        cell = finished_cell(planned, broken, reference);
    }
    const std::lock_guard lock(mutex_);
    if (closed_) { return; }
    if (!cell.trajectory_sum.empty()) {
        write_atomically(folder_ / trajectory_file(cell.hash), trajectory_text(outcome.trajectory));
    }
    journal_.append(journal_line(cell, build_));
    weight_done_ += planned.weight;
    finished_.insert_or_assign(cell.hash, std::move(cell));
}

void Campaign::fail(std::exception_ptr error) {
    {
        const std::lock_guard lock(mutex_);
        error_ = error_ ? error_ : error;
    }
    stop.request_stop();
}

ProgressState Campaign::progress() const {
    const std::lock_guard lock(mutex_);
    const auto failed =
        std::count_if(finished_.begin(), finished_.end(), [](const auto& one) { return one.second.failed(); });
    return {finished_.size(), finished_.size() + mine_.size(), static_cast<std::size_t>(failed), weight_done_,
            weight_total_};
}

void remove_results(const std::filesystem::path& folder) {
    const std::pair<const char*, const char*> ours[] = {
        {"journal", ".jsonl"}, {"results", ".jsonl"}, {"results", ".csv"}, {"manifest", ".json"}};
    for (const auto& [stem, extension] : ours) {
        for (const auto& file : files_like(folder, stem, extension)) { std::filesystem::remove(file); }
    }
    std::filesystem::remove_all(folder / "trajectories");
}

// Starts the workers and waits; true if some of them did not stop in time.
bool run_workers(const std::shared_ptr<Campaign>& campaign, const RunSettings& settings, Progress& progress) {
    std::vector<std::jthread> threads;
    campaign->working = settings.workers;
    for (unsigned i = 0; i < settings.workers; ++i) {
        threads.emplace_back([campaign] {
            try {
                campaign->work(campaign->stop.get_token());
            } catch (...) { campaign->fail(std::current_exception()); }
            --campaign->working;
        });
    }
    const auto pause = std::chrono::milliseconds(20);
    double waited = 0;
    while (campaign->working > 0 && waited < settings.grace) {
        std::this_thread::sleep_for(pause);
        progress.show(campaign->progress());
        if (InterruptGuard::requested()) {
            campaign->stop.request_stop();
            waited += std::chrono::duration<double>(pause).count();
        }
    }
    progress.clear();
    campaign->close();
    const bool left_behind = campaign->working > 0;
    for (std::jthread& thread : threads) { left_behind ? thread.detach() : thread.join(); }
    return left_behind;
}

void prepare(const std::filesystem::path& folder, const Plan& plan) {
    make_folder(folder);
    if (plan.config.samples > 0) { make_folder(folder / "trajectories"); }
    if (!plan.references.empty()) { make_folder(folder / "references"); }
}

JournalContents earlier_results(const std::filesystem::path& folder, const RunSettings& settings,
                                std::ostream& messages) {
    if (!settings.resume) {
        check_output_folder(folder, settings);
        if (settings.overwrite) { remove_results(folder); }
        return {};
    }
    JournalContents earlier = read_journals(folder, settings.build);
    for (const std::string& complaint : earlier.complaints) { messages << complaint << "\n"; }
    mend_journal(journal_file(folder, shard_name(settings)));
    return earlier;
}

Outcome thrown(const std::string& what) {
    Outcome outcome;
    outcome.status = "exception";
    outcome.detail = what;
    return outcome;
}

void list_failures(const Plan& plan, const Finished& finished, CampaignReport& report) {
    for (const PlannedCell& planned : plan.cells) {
        const auto found = finished.find(planned.hash);
        if (found != finished.end() && found->second.failed()) {
            report.failures.emplace_back(failure_text(planned, found->second), found->second.status);
        }
    }
}

}  // namespace

Outcome run_cell(const PlannedCell& planned, const Engine& engine, const Reference* reference,
                 const std::stop_token& stop) {
    try {
        return engine.run(planned.cell, reference, stop);
    } catch (const std::exception& error) { return thrown(error.what()); } catch (...) {
        return thrown("something that is no std::exception was thrown");
    }
}

std::string shard_name(const RunSettings& settings) {
    return settings.shards == 1 ? "" : fmt::format("{}-of-{}", settings.shard, settings.shards);
}

void check_output_folder(const std::filesystem::path& folder, const RunSettings& settings) {
    std::error_code error;
    if (std::filesystem::exists(folder, error) && !std::filesystem::is_directory(folder, error)) {
        throw UsageError(fmt::format("{}: expected a folder for the results, got a file", folder.string()));
    }
    const bool used = settings.shards == 1 ? holds_journal(folder)
                                           : std::filesystem::exists(journal_file(folder, shard_name(settings)), error);
    if (used && !settings.resume && !settings.overwrite) {
        throw UsageError(
            fmt::format("{}: this folder holds results already: --resume keeps what is valid and computes the "
                        "rest, --overwrite starts again",
                        folder.string()));
    }
}

CampaignReport run_campaign(const Plan& plan, const Engines& engines, const std::filesystem::path& folder,
                            const RunSettings& settings, std::ostream& messages) {
    const InterruptGuard guard;
    prepare(folder, plan);
    const std::string shard = shard_name(settings);
    const FolderLock lock(folder, shard);
    const JournalContents earlier = earlier_results(folder, settings, messages);
    prepare(folder, plan);
    const auto campaign = std::make_shared<Campaign>(plan, engines, folder, settings);
    CampaignReport report;
    report.reused = campaign->reuse(earlier, settings);
    campaign->enqueue();
    ManifestTimes times{utc_now(), ""};
    write_manifest(manifest_file(folder, shard), plan, settings.build, times,
                   count_cells(plan, campaign->finished(), settings));
    Progress progress(messages, plan.config.name, settings.terminal);
    report.workers_left_behind = run_workers(campaign, settings, progress);
    if (const auto error = campaign->error()) { std::rethrow_exception(error); }
    const Finished finished = campaign->finished();
    if (shard.empty()) { write_results(plan, finished, folder); }
    times.ended = utc_now();
    report.counts = count_cells(plan, finished, settings);
    report.interrupted = InterruptGuard::requested() && report.counts.missing > 0;
    write_manifest(manifest_file(folder, shard), plan, settings.build, times, report.counts);
    list_failures(plan, finished, report);
    return report;
}

}  // namespace kreisel
