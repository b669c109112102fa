// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <ostream>
#include <thread>

#include "driver/campaign/earlier.hpp"
#include "driver/campaign/geometry.hpp"
#include "driver/campaign/interrupt.hpp"
#include "driver/campaign/results.hpp"
#include "driver/campaign/work.hpp"
#include "records/folder/owned_files.hpp"
#include "records/provenance.hpp"
#include "records/remarks/lost_integrals.hpp"
#include "records/remarks/past_horizon.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

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

// What the manifest says of a run that begins. What an earlier one has written stays ours.
ManifestState begun(const Plan& plan, const RunSettings& settings, const Earlier& earlier) {
    ManifestState state{.build = settings.build,
                        .started = utc_now(),
                        .counts = count_cells(plan, {}, settings),
                        .files = files_of_run(shard_name(settings), plan.config.samples > 0, !plan.references.empty()),
                        .earlier = earlier.runs};
    for (const std::string& file : earlier.files) {
        const bool known = std::find(state.files.begin(), state.files.end(), file) != state.files.end();
        if (!known) { state.files.push_back(file); }
    }
    return state;
}

}  // namespace

std::string shard_name(const RunSettings& settings) {
    return settings.shards == 1 ? "" : fmt::format("{}-of-{}", settings.shard, settings.shards);
}

CampaignReport run_campaign(const Plan& plan, const Engines& engines, const std::filesystem::path& folder,
                            const RunSettings& settings, std::ostream& messages) {
    const InterruptGuard guard;
    prepare(folder, plan);
    const std::string shard = shard_name(settings);
    const FolderLock lock(folder, shard);
    const Earlier earlier = earlier_results(plan, folder, settings, messages);
    ManifestState state = begun(plan, settings, earlier);
    const auto write_state = [&] { write_manifest(manifest_file(folder, shard), manifest_subject(plan), state); };
    write_state();  // before anything that it lists
    remove_leftovers(plan, folder, settings, earlier.journals);
    const auto campaign = std::make_shared<Campaign>(plan, engines, folder, settings);
    CampaignReport report;
    report.reused = campaign->reuse(earlier.journals, settings);
    campaign->enqueue();
    state.counts = count_cells(plan, campaign->finished(), settings);
    if (report.reused > 0) { write_state(); }
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
    if (shard.empty()) {
        write_results(plan, finished, table_units(plan, engines.binary64), folder);
        write_geometries(plan, engines.binary64, folder);
    }
    state.counts = report.counts = count_cells(plan, finished, settings);
    report.interrupted = InterruptGuard::requested() && report.counts.missing > 0;
    if (report.counts.missing == 0 && (!earlier.journals.foreign.empty() || earlier.damaged)) {
        prune_journal(journal_file(folder, shard), settings.build);
    }
    state.ended = utc_now();
    state.journal = std::filesystem::file_size(journal_file(folder, shard));
    write_state();
    list_failures(plan, finished, report);
    const std::vector<ResultRow> rows = rows_of(finished);
    report.notes = past_horizon_notes(rows);
    for (std::string& note : lost_integral_notes(rows)) { report.notes.push_back(std::move(note)); }
    report.parts = trajectory_parts(folder);
    return report;
}

}  // namespace kreisel
