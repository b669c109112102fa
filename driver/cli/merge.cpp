// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/merge.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "driver/campaign/results.hpp"
#include "records/journal.hpp"
#include "records/provenance.hpp"
#include "records/trajectory_file.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

// The config all folders agree on.
Document common_config(const Paths& folders, const std::string& build) {
    std::optional<ManifestContents> first;
    for (const auto& folder : folders) {
        if (!std::filesystem::is_directory(folder)) {
            throw FileError(fmt::format("{}: there is no such folder", folder.string()));
        }
        const auto files = files_like(folder, "manifest", ".json");
        if (files.empty()) {
            throw UsageError(fmt::format("{}: expected a folder that kreisel run has written, got one without manifest",
                                         folder.string()));
        }
        for (const auto& file : files) {
            ManifestContents manifest = read_manifest(file);
            if (manifest.build != build) {
                throw UsageError(fmt::format("{}: expected results of this build ({}), got build {}", file.string(),
                                             build, manifest.build));
            }
            if (first && first->config.value != manifest.config.value) {
                throw UsageError(
                    fmt::format("{}: expected the same config in all folders, got another one", file.string()));
            }
            if (!first) { first = std::move(manifest); }
        }
    }
    return first->config;
}

void copy_trajectory(const CellRecord& cell, const std::filesystem::path& from, const std::filesystem::path& to) {
    if (cell.outcome.trajectory_sum.empty() || from == to) { return; }
    const std::string file = trajectory_file(cell.identity.cell);
    make_folder(to / "trajectories");
    write_atomically(to / file, read_text(from / file));
}

void copy_references(const std::filesystem::path& from, const std::filesystem::path& to) {
    if (from == to || !std::filesystem::is_directory(from / "references")) { return; }
    make_folder(to / "references");
    for (const auto& file : files_like(from / "references", "", ".json")) {
        write_atomically(to / "references" / file.filename(), read_text(file));
    }
}

// Lets the merged folder be resumed, and merged again, like any other.
void write_journal(const std::filesystem::path& folder, const std::map<std::string, CellRecord>& finished,
                   const std::string& build) {
    std::string text;
    for (const auto& [hash, cell] : finished) { text += journal_line(cell, build) + "\n"; }
    write_atomically(journal_file(folder, ""), text);
}

}  // namespace

Exit merge_command(const Paths& folders, const std::filesystem::path& output, const std::string& build,
                   const Engines& engines, const Terminal& terminal) {
    const Plan plan = plan_of(common_config(folders, build), engines);
    const std::filesystem::path target = output.empty() ? folders.front() : output;
    make_folder(target);
    const FolderLock lock(target, "");
    ManifestTimes times{utc_now(), ""};
    std::map<std::string, CellRecord> finished;
    for (const auto& folder : folders) {
        JournalContents journals = read_journals(folder, build);
        for (const std::string& complaint : journals.complaints) { fmt::print(terminal.messages, "{}\n", complaint); }
        if (!journals.foreign.empty()) {
            fmt::print(terminal.messages, "{}: {} cells of another build are left out\n", folder.string(),
                       journals.foreign.size());
        }
        for (const auto& [hash, cell] : journals.cells) { copy_trajectory(cell, folder, target); }
        copy_references(folder, target);
        finished.merge(journals.cells);
    }
    write_journal(target, finished, build);
    write_results(plan, finished, table_units(plan, engines.binary64), target);
    const CellCounts counts = count_cells(plan, finished, {});
    times.ended = utc_now();
    write_manifest(manifest_file(target, ""), manifest_subject(plan), build, times, counts);
    fmt::print(terminal.messages, "{}: {} ok, {} skipped, {} failed, {} missing; results in {}\n", plan.config.name,
               counts.ok, counts.skipped, counts.failed, counts.missing, target.string());
    return counts.failed + counts.missing > 0 ? Exit::cells_failed : Exit::ok;
}

}  // namespace kreisel
