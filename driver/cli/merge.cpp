// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/merge.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <optional>

#include "driver/campaign/finished.hpp"
#include "driver/campaign/geometry.hpp"
#include "driver/campaign/parts.hpp"
#include "driver/campaign/results.hpp"
#include "records/folder/damage.hpp"
#include "records/folder/owned_files.hpp"
#include "records/journal.hpp"
#include "records/provenance.hpp"
#include "records/reference_store.hpp"
#include "records/trajectory_file.hpp"
#include "support/files.hpp"
#include "support/in_shell.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

// What the folders agree on, and how their runs went.
struct MergedManifests {
    std::optional<Document> config;
    PlanOfParts plan;
    std::vector<std::string> runs;
    std::vector<std::string> damage;  // manifests that are left out
};

void add_manifest(const std::filesystem::path& file, const std::string& build, MergedManifests& merged) {
    ManifestContents manifest = read_manifest(file);
    if (!build.empty() && manifest.state.build != build) {
        throw UsageError(fmt::format("{}: expected results of this build ({}), got build {}; --mixed takes both",
                                     file.string(), build, manifest.state.build));
    }
    merged.plan.add(file, manifest.state.plan);
    if (merged.config && merged.config->value != manifest.config.value) {
        throw UsageError(fmt::format("{}: expected the same config in all folders, got another one", file.string()));
    }
    if (!merged.config) { merged.config = std::move(manifest.config); }
    for (std::string& run : manifest.state.earlier) { merged.runs.push_back(std::move(run)); }
    merged.runs.push_back(std::move(manifest.run));
}

// `build` empty: of any build. Of a part whose manifest is damaged the journal is taken nevertheless: its lines have
// sums, and tell by themselves of which cell and build they are.
MergedManifests read_manifests(const Paths& folders, const std::string& build) {
    MergedManifests merged;
    for (const auto& folder : folders) {
        if (std::error_code error; !std::filesystem::is_directory(folder, error)) {
            throw FileError(fmt::format("{}: there is no such folder", folder.string()));
        }
        const auto files = shard_files(folder, "manifest", ".json");
        if (files.empty()) {
            const std::vector<std::string> damage = run_damage(folder);
            merged.damage.insert(merged.damage.end(), damage.begin(), damage.end());
            if (!damage.empty()) { continue; }
            throw UsageError(fmt::format("{}: expected a folder that kreisel run has written, got one without manifest",
                                         folder.string()));
        }
        for (const auto& file : files) {
            try {
                add_manifest(file, build, merged);
            } catch (const FileError& error) { merged.damage.emplace_back(error.what()); }
        }
    }
    if (!merged.config) { throw FileError(merged.damage.front()); }
    return merged;
}

// Results of another config would be lost.
void require_no_others(const std::filesystem::path& target, const Document& config) {
    for (const auto& file : shard_files(target, "manifest", ".json")) {
        try {
            if (read_manifest(file).config.value == config.value) { continue; }
        } catch (const FileError& error) {
            throw FileError(
                fmt::format("{}; what else is in {} is therefore not written over: -o FOLDER merges into "
                            "another folder",
                            error.what(), target.string()));
        }
        throw UsageError(
            fmt::format("{}: expected a new folder or results of the config that is merged, got those of "
                        "another one ({})",
                        target.string(), file.string()));
    }
}

// Puts the cells of several folders together, in one journal. What is damaged is left out, and named.
class Merger {
  public:
    Merger(const Plan& plan, std::filesystem::path target, std::string build, std::ostream& messages)
        : plan_(plan),
          target_(std::move(target)),
          build_(std::move(build)),
          messages_(messages),
          journal_(journal_file(target_, "")),
          finished_(plan.cells.size()),
          number_(finished_.add_journal(journal_file(target_, ""))) {}

    void add(const std::filesystem::path& folder) {
        for (const std::string& text : run_damage(folder)) { complain(text); }
        const JournalContents journals = journals_of(folder);
        for (const std::string& text : journals.complaints) { complain(text); }
        if (!journals.foreign.empty()) {
            fmt::print(messages_, "{}: {} cells of another build are left out\n", folder.string(),
                       journals.foreign.size());
        }
        const JournalLines lines = journals.lines();
        for (std::size_t i = 0; i < plan_.cells.size(); ++i) {
            const auto found = finished_.has(i) ? journals.cells.end() : journals.cells.find(plan_.cells[i].hash());
            if (found != journals.cells.end()) { add_cell(i, lines.line(found->second), folder); }
        }
        copy_references(folder);
    }

    // Lets the merged folder be resumed, and merged again, like any other.
    void keep_journal() { journal_.keep(); }

    /// Can be read when the journal is kept.
    const FinishedCells& finished() const { return finished_; }
    bool damaged() const { return damaged_; }

  private:
    JournalContents journals_of(const std::filesystem::path& folder) {
        try {
            return read_journals(folder, build_);
        } catch (const FileError& error) {
            complain(error.what());
            return {};
        }
    }

    void complain(const std::string& text) {
        fmt::print(messages_, "{}\n", text);
        damaged_ = true;
    }

    // Unless its samples are damaged: the cell then counts as missing.
    void add_cell(std::size_t index, const std::string& line, const std::filesystem::path& from) {
        const auto cell = read_journal_line(line);
        if (!cell || !copy_trajectory(cell->record, from)) { return; }
        finished_.set(index, ending_of(cell->record.outcome),
                      {number_, static_cast<std::uint32_t>(line.size()), size_});
        journal_.add(line + "\n");
        size_ += line.size() + 1;
    }

    // False if its samples are damaged.
    bool copy_trajectory(const CellRecord& cell, const std::filesystem::path& from) {
        const std::string& sum = cell.outcome.trajectory_sum;
        if (sum.empty()) { return true; }
        const std::string damage = trajectory_damage(from, cell.identity.cell, sum);
        if (!damage.empty()) { complain(damage); }
        if (!damage.empty() || from == target_) { return damage.empty(); }
        const std::string file = trajectory_file(cell.identity.cell);
        make_folder(target_ / "trajectories");
        AtomicFile copy(target_ / file);
        for_each_piece(from / file, [&](std::string_view piece) { copy.add(piece); });
        copy.keep();
        return true;
    }

    void copy_references(const std::filesystem::path& from) {
        std::error_code error;
        if (from == target_ || !std::filesystem::is_directory(from / "references", error)) { return; }
        make_folder(target_ / "references");
        for (const auto& file : files_like(from / "references", "", ".json")) {
            if (!what_is_no_file(file).empty()) { continue; }  // run_damage says so
            const std::string text = read_text(file);
            if (is_whole_reference(text)) { write_atomically(target_ / "references" / file.filename(), text); }
        }
    }

    const Plan& plan_;
    const std::filesystem::path target_;
    const std::string build_;
    std::ostream& messages_;
    AtomicFile journal_;
    std::uint64_t size_ = 0;  // of the journal
    FinishedCells finished_;
    const std::uint32_t number_;  // of the journal
    bool damaged_ = false;
};

void list_missing(const Plan& plan, const FinishedCells& finished, const std::filesystem::path& target,
                  std::ostream& messages) {
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        if (!finished.has(i)) { fmt::print(messages, "missing: {}\n", cell_text(plan.cells[i])); }
    }
    fmt::print(messages, "compute what is missing with: kreisel run {} -o {} --resume\n",
               in_shell(manifest_file(target, "").string()), in_shell(target.string()));
}

}  // namespace

Exit merge_command(const Paths& folders, const std::filesystem::path& output, const std::string& build, bool mixed,
                   const Engines& engines, const Terminal& terminal) {
    const std::string taken = mixed ? "" : build;
    MergedManifests manifests = read_manifests(folders, taken);
    if (!manifests.plan.warning().empty()) { fmt::print(terminal.messages, "{}\n", manifests.plan.warning()); }
    const Plan plan = plan_of(*manifests.config, engines);
    const std::filesystem::path target = output.empty() ? folders.front() : output;
    make_folder(target);
    const FolderLock lock(target, "");
    require_no_others(target, *manifests.config);
    OwnedFiles(target).require(files_of_run("", false, false));
    ManifestState state{.build = build,
                        .started = utc_now(),
                        .counts = count_cells(plan, FinishedCells(plan.cells.size()), {}),
                        .files = files_of_run("", plan.config.samples > 0, !plan.references.empty()),
                        .earlier = std::move(manifests.runs)};
    const auto write_state = [&] { write_manifest(manifest_file(target, ""), manifest_subject(plan), state); };
    write_state();  // before anything that it lists
    remove_torn_files(target, OwnedFiles(target));
    Merger merger(plan, target, taken, terminal.messages);
    for (const auto& folder : folders) { merger.add(folder); }
    merger.keep_journal();
    write_results(plan, merger.finished(), table_units(plan, engines.binary64), target);
    write_geometries(plan, engines.binary64, target);
    const CellCounts counts = state.counts = count_cells(plan, merger.finished(), {});
    state.ended = utc_now();
    state.journal = std::filesystem::file_size(journal_file(target, ""));
    write_state();
    fmt::print(terminal.messages, "{}: {} ok, {} skipped, {} failed, {} missing; results in {}\n", plan.config.name,
               counts.ok, counts.skipped, counts.failed, counts.missing, target.string());
    if (counts.missing > 0) { list_missing(plan, merger.finished(), target, terminal.messages); }
    if (merger.damaged() || counts.missing > 0) { return Exit::io; }
    return counts.failed > 0 ? Exit::cells_failed : Exit::ok;
}

}  // namespace kreisel
