// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ostream>
#include <set>
#include <thread>

#include "driver/campaign/dispatch/dispatcher.hpp"
#include "driver/campaign/dispatch/work.hpp"
#include "driver/campaign/earlier.hpp"
#include "driver/campaign/geometry.hpp"
#include "driver/campaign/interrupt.hpp"
#include "driver/campaign/results.hpp"
#include "driver/campaign/workers/limits.hpp"
#include "driver/plan/shards.hpp"
#include "records/folder/owned_files.hpp"
#include "records/provenance.hpp"
#include "records/remarks/lost_integrals.hpp"
#include "records/remarks/past_horizon.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

// The references that cells of this run need, and those that are damaged, once each.
std::vector<std::string> wanted_references(const Plan& plan, const Ledger& ledger, const ReferenceStore& store) {
    std::set<std::string> known;
    std::vector<std::string> wanted;
    for (const std::size_t index : ledger.mine()) {
        const std::string& hash = plan.cells[index].reference();
        if (!hash.empty() && known.insert(hash).second) { wanted.push_back(hash); }
    }
    for (const auto& [hash, planned] : plan.references) {
        if (store.is_damaged(planned) && known.insert(hash).second) { wanted.push_back(hash); }
    }
    return wanted;
}

// Concurrent cells would measure each other's memory and share the caches: one worker takes their times in turn.
Resources resources_of(const Plan& plan, const RunSettings& settings) {
    constexpr double usual_share = 0.8;
    const auto usual = static_cast<std::uint64_t>(usual_share * static_cast<double>(allowed_memory()));
    return {plan.config.runs_alone() ? 1 : settings.workers, settings.max_memory > 0 ? settings.max_memory : usual,
            settings.timeout, settings.grace};
}

std::string without_proc(unsigned workers) {
    return fmt::format("/proc is not mounted: {}; neither limits of a cgroup nor the memory of a worker are known",
                       workers == 1 ? "cells were computed one after the other (-j N: N at the same time)"
                                    : fmt::format("{} cells were computed at the same time", workers));
}

void say_of_references(const Plan& plan, const ProgressState& progress, const FailedReferences& failed,
                       CampaignReport& report) {
    report.references = progress.references_done - failed.size();
    for (const auto& [hash, end] : failed) {
        const PlannedReference& planned = plan.references.at(hash);
        report.reference_failures.push_back(
            fmt::format("{}: reference of {} at t = {} s: {}", end.status, planned.problem, planned.t_end, end.detail));
    }
}

void run_workers(const Plan& plan, const Forker& forker, Ledger& ledger, const ReferenceStore& store,
                 const RunSettings& settings, std::ostream& messages, CampaignReport& report) {
    Progress progress(messages, plan.config.name, settings.terminal);
    const auto start = std::chrono::steady_clock::now();
    Dispatcher dispatcher(plan, forker, ledger, resources_of(plan, settings), [&](Dispatcher& run) {
        if (progress.is_due()) { progress.show(run.progress()); }
    });
    dispatcher.enqueue(wanted_references(plan, ledger, store),
                       settings.references_only ? std::vector<std::size_t>() : ledger.mine());
    dispatcher.run();
    if (plan.config.runs_alone() && !settings.references_only) { dispatcher.time_in_turn(); }
    dispatcher.dismiss_idle();
    progress.clear();
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report.notes = dispatcher.notes();
    if (!has_proc()) { report.notes.push_back(without_proc(settings.workers)); }
    say_of_references(plan, ledger.progress, dispatcher.failed_references(), report);
    report.interrupted = dispatcher.interrupted() && dispatcher.has_left_something();
}

// Once everything is computed.
void forget_what_is_damaged(const std::filesystem::path& journal, const Earlier& earlier, const CellCounts& counts,
                            const RunSettings& settings) {
    if (counts.missing == 0 && (!earlier.journals.foreign.empty() || earlier.damaged)) {
        prune_journal(journal, settings.build);
    }
}

// Shards have none: merge makes them.
void close_results(const Plan& plan, const Engines& engines, const std::filesystem::path& folder,
                   const RunSettings& settings, const FinishedCells& finished) {
    if (settings.shards > 1 || settings.references_only) { return; }
    write_results(plan, finished, table_units(plan, engines.binary64), folder);
    write_geometries(plan, engines.binary64, folder);
}

void prepare(const std::filesystem::path& folder, const Plan& plan) {
    make_folder(folder);
    if (plan.config.samples > 0) { make_folder(folder / "trajectories"); }
    if (!plan.references.empty()) { make_folder(folder / "references"); }
}

void list_failures(const Plan& plan, const FinishedCells& finished, CampaignReport& report) {
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        if (finished.end(i) != CellEnd::failed) { continue; }
        const CellOutcome outcome = finished.record(i).outcome;
        report.failures.emplace_back(failure_text(plan.cells[i], outcome), outcome.status);
    }
}

// Of a cell of which nothing is remarkable its label is enough, which is not read from the journal.
ResultRow remarked_row(const Plan& plan, const FinishedCells& finished, std::size_t index) {
    if (finished.is_remarkable(index)) { return result_row(finished.record(index)); }
    return {.label = plan.cells[index].label(), .status = status::ok};
}

// The labels of problems of whose cells something is to be said.
std::set<std::string> remarkable_labels(const Plan& plan, const FinishedCells& finished) {
    std::set<std::string> labels;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        if (finished.end(i) == CellEnd::ok && finished.is_remarkable(i)) { labels.insert(plan.cells[i].label()); }
    }
    return labels;
}

void add_remarks(const Plan& plan, const FinishedCells& finished, CampaignReport& report) {
    const std::set<std::string> labels = remarkable_labels(plan, finished);
    if (labels.empty()) { return; }
    PastHorizon past_horizon;
    LostIntegrals lost_integrals;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        if (finished.end(i) != CellEnd::ok || !labels.contains(plan.cells[i].label())) { continue; }
        const ResultRow row = remarked_row(plan, finished, i);
        past_horizon.add(row);
        lost_integrals.add(row);
    }
    for (std::string& note : past_horizon.notes()) { report.notes.push_back(std::move(note)); }
    for (std::string& note : lost_integrals.notes()) { report.notes.push_back(std::move(note)); }
}

void say_of_cells(const Plan& plan, const FinishedCells& finished, CampaignReport& report) {
    list_failures(plan, finished, report);
    add_remarks(plan, finished, report);
}

// What the manifest says of a run that begins. What an earlier one has written stays ours.
ManifestState begun(const Plan& plan, const RunSettings& settings, const Earlier& earlier) {
    ManifestState state{.build = settings.build,
                        .started = utc_now(),
                        .counts = count_cells(plan, FinishedCells(plan.cells.size()), settings),
                        .files = files_of_run(shard_name(settings), plan.config.samples > 0, !plan.references.empty()),
                        .earlier = earlier.runs,
                        .plan = settings.shards > 1 ? plan_digest(plan, settings.shards) : ""};
    for (const std::string& file : earlier.files) {
        const bool known = std::find(state.files.begin(), state.files.end(), file) != state.files.end();
        if (!known) { state.files.push_back(file); }
    }
    return state;
}

}  // namespace

unsigned usual_workers() { return has_proc() ? std::max(1U, std::thread::hardware_concurrency()) : 1; }

std::string shard_name(const RunSettings& settings) {
    return settings.shards == 1 ? "" : fmt::format("{}-of-{}", settings.shard, settings.shards);
}

CampaignReport run_campaign(const Plan& plan, const Engines& engines, const std::filesystem::path& folder,
                            const RunSettings& settings, std::ostream& messages) {
    const InterruptGuard guard;
    WorkerTasks work(plan, engines, folder, settings);
    const Forker forker([&](const Descriptor& socket, const Printed& printed, const Watch& watch) {
        work.serve(socket, printed, watch);
    });
    prepare(folder, plan);
    const std::string shard = shard_name(settings);
    const FolderLock lock(folder, shard);
    const Earlier earlier = earlier_results(plan, folder, settings, messages);
    ManifestState state = begun(plan, settings, earlier);
    const auto write_state = [&] { write_manifest(manifest_file(folder, shard), manifest_subject(plan), state); };
    write_state();  // before anything that it lists
    remove_leftovers(plan, folder, settings, earlier.journals);
    CampaignReport report;
    Ledger ledger(plan, folder, settings);
    report.reused = ledger.reuse(earlier.journals, settings);
    for (const std::string& text : ledger.damage()) { messages << text << "\n"; }
    state.counts = count_cells(plan, ledger.finished(), settings);
    if (report.reused > 0) { write_state(); }
    const ReferenceStore store(folder, settings.cache, engines.reference_digest(), settings.references);
    run_workers(plan, forker, ledger, store, settings, messages, report);
    state.counts = report.counts = count_cells(plan, ledger.finished(), settings);
    close_results(plan, engines, folder, settings, ledger.finished());
    say_of_cells(plan, ledger.finished(), report);
    forget_what_is_damaged(journal_file(folder, shard), earlier, report.counts, settings);
    state.ended = utc_now();
    state.journal = std::filesystem::file_size(journal_file(folder, shard));
    write_state();
    report.parts = trajectory_parts(folder);
    return report;
}

}  // namespace kreisel
