// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/campaign.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <ostream>
#include <thread>

#include "driver/campaign/interrupt.hpp"
#include "driver/campaign/results.hpp"
#include "driver/campaign/work.hpp"
#include "records/provenance.hpp"
#include "records/remarks/lost_integrals.hpp"
#include "records/remarks/past_horizon.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

void remove_results(const std::filesystem::path& folder) {
    const std::pair<const char*, const char*> ours[] = {
        {"journal", ".jsonl"}, {"results", ".jsonl"}, {"results", ".csv"}, {"manifest", ".json"}};
    for (const auto& [stem, extension] : ours) {
        for (const auto& file : files_like(folder, stem, extension)) { std::filesystem::remove(file); }
    }
    std::filesystem::remove_all(folder / "trajectories");
}

// Starts the workers and waits; true if some did not stop in time.
bool run_workers(const std::shared_ptr<Campaign>& campaign, unsigned workers, double grace, Progress& progress) {
    std::vector<std::jthread> threads;
    campaign->working = workers;
    for (unsigned i = 0; i < workers; ++i) {
        threads.emplace_back([campaign] {
            try {
                campaign->work(campaign->stop.get_token());
            } catch (...) { campaign->fail(std::current_exception()); }
            --campaign->working;
        });
    }
    const auto pause = std::chrono::milliseconds(20);
    double waited = 0;
    while (campaign->working > 0 && waited < grace) {
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

std::size_t foreign_cells(const Plan& plan, const JournalContents& earlier, const RunSettings& settings) {
    std::size_t count = 0;
    for (std::size_t i = settings.shard - 1; i < plan.cells.size(); i += settings.shards) {
        count += earlier.foreign.count(plan.cells[i].hash);
    }
    return count;
}

JournalContents earlier_results(const Plan& plan, const std::filesystem::path& folder, const RunSettings& settings,
                                std::ostream& messages) {
    if (!settings.resume) {
        check_output_folder(folder, settings);
        if (settings.overwrite) { remove_results(folder); }
        return {};
    }
    JournalContents earlier = read_journals(folder, settings.build);
    for (const std::string& complaint : earlier.complaints) { messages << complaint << "\n"; }
    if (const std::size_t again = foreign_cells(plan, earlier, settings); again > 0) {
        messages << fmt::format("{} cells of another build are computed again\n", again);
    }
    mend_journal(journal_file(folder, shard_name(settings)));
    return earlier;
}

void list_failures(const Plan& plan, const Finished& finished, CampaignReport& report) {
    for (const PlannedCell& planned : plan.cells) {
        const auto found = finished.find(planned.hash);
        if (found != finished.end() && found->second.outcome.failed()) {
            report.failures.emplace_back(failure_text(planned, found->second.outcome), found->second.outcome.status);
        }
    }
}

std::vector<ResultRow> rows_of(const Finished& finished) {
    std::vector<ResultRow> rows;
    for (const auto& [hash, cell] : finished) { rows.push_back(result_row(cell)); }
    return rows;
}

}  // namespace

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
    const JournalContents earlier = earlier_results(plan, folder, settings, messages);
    prepare(folder, plan);
    const auto campaign = std::make_shared<Campaign>(plan, engines, folder, settings);
    CampaignReport report;
    report.reused = campaign->reuse(earlier, settings);
    campaign->enqueue();
    ManifestTimes times{utc_now(), ""};
    write_manifest(manifest_file(folder, shard), manifest_subject(plan), settings.build, times,
                   count_cells(plan, campaign->finished(), settings));
    Progress progress(messages, plan.config.name, settings.terminal);
    const auto start = std::chrono::steady_clock::now();
    // Concurrent cells would measure each other's memory and share the caches. One worker takes their times in turn.
    const unsigned workers = plan.config.runs_alone() ? 1 : settings.workers;
    report.workers_left_behind = run_workers(campaign, workers, settings.grace, progress);
    if (const auto error = campaign->error()) { std::rethrow_exception(error); }
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (const std::string complaint = campaign->cache_complaint(); !complaint.empty()) {
        messages << "note: references are kept in the results only: " << complaint << "\n";
    }
    const Finished finished = campaign->finished();
    if (shard.empty()) { write_results(plan, finished, table_units(plan, engines.binary64), folder); }
    times.ended = utc_now();
    report.counts = count_cells(plan, finished, settings);
    report.interrupted = InterruptGuard::requested() && report.counts.missing > 0;
    write_manifest(manifest_file(folder, shard), manifest_subject(plan), settings.build, times, report.counts);
    if (report.counts.missing == 0 && !earlier.foreign.empty()) {
        prune_journal(journal_file(folder, shard), settings.build);
    }
    list_failures(plan, finished, report);
    const std::vector<ResultRow> rows = rows_of(finished);
    report.notes = past_horizon_notes(rows);
    for (std::string& note : lost_integral_notes(rows)) { report.notes.push_back(std::move(note)); }
    report.parts = trajectory_parts(folder);
    return report;
}

}  // namespace kreisel
