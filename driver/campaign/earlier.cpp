// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/earlier.hpp"

#include <fmt/format.h>

#include <ostream>
#include <set>

#include "driver/campaign/parts.hpp"
#include "driver/plan/shards.hpp"
#include "records/folder/damage.hpp"
#include "records/folder/owned_files.hpp"
#include "records/manifest.hpp"
#include "records/reference_store.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

std::size_t foreign_cells(const Plan& plan, const JournalContents& earlier, const RunSettings& settings) {
    std::size_t count = 0;
    for (const std::size_t i : cells_of_shard(plan, settings.shard, settings.shards)) {
        count += earlier.foreign.count(plan.cells[i].hash());
    }
    return count;
}

std::set<std::string> cells_of(const Plan& plan, const RunSettings& settings) {
    std::set<std::string> cells;
    for (const std::size_t i : cells_of_shard(plan, settings.shard, settings.shards)) {
        cells.insert(plan.cells[i].hash());
    }
    return cells;
}

// Of a part among others its own: they keep samples in one folder.
void remove_results(const Plan& plan, const std::filesystem::path& folder, const RunSettings& settings) {
    const std::string shard = shard_name(settings);
    const auto manifests = shard_files(folder, "manifest", ".json");
    const bool among_others = !shard.empty() && manifests != std::vector{manifest_file(folder, shard)};
    const std::set<std::string> own = among_others ? cells_of(plan, settings) : std::set<std::string>();
    const auto is_mine = [&](const std::string& cell) { return !among_others || own.contains(cell); };
    (shard.empty() ? OwnedFiles(folder) : OwnedFiles::of_shard(folder, shard)).remove_results(shard, is_mine);
}

// The files that a run would write.
std::vector<std::string> would_write(const Plan& plan, const RunSettings& settings) {
    std::vector<std::string> paths = files_of_run(shard_name(settings), false, false);
    for (const std::size_t i : cells_of_shard(plan, settings.shard, settings.shards)) {
        if (plan.config.samples > 0) { paths.push_back(trajectory_file(plan.cells[i].hash())); }
    }
    for (const auto& [hash, planned] : plan.references) { paths.push_back(reference_file("", hash).string()); }
    return paths;
}

// Whether the folder comes from a version that listed nothing, or its manifest is lost: then a journal, whose lines
// have sums, shows that it is one of ours.
bool is_unlisted(const std::filesystem::path& folder) {
    try {
        return OwnedFiles(folder).empty() && !shard_files(folder, "journal", ".jsonl").empty();
    } catch (const FileError&) { return true; }  // run_damage says so
}

bool holds_results(const std::filesystem::path& folder) {
    std::error_code error;
    const auto results = folder / "results.jsonl";
    return holds_journal(folder) ||
           (std::filesystem::is_regular_file(results, error) && std::filesystem::file_size(results, error) > 0);
}

// Runs and files of a manifest that is there.
void add_earlier_manifest(const std::filesystem::path& manifest, Earlier& earlier) {
    std::error_code error;
    if (!std::filesystem::exists(manifest, error)) { return; }
    try {
        ManifestContents contents = read_manifest(manifest);
        earlier.runs = std::move(contents.state.earlier);
        earlier.runs.push_back(std::move(contents.run));
        earlier.files = std::move(contents.state.files);
    } catch (const FileError&) {  // it is damaged, which run_damage says
        return;
    } catch (const UsageError&) {  // the config of another version, which no run of this one goes on with
        return;
    }
}

}  // namespace

void remove_leftovers(const Plan& plan, const std::filesystem::path& folder, const RunSettings& settings,
                      const JournalContents& journals) {
    const auto is_stale = [&](const std::string& cell) { return !journals.interrupted.contains(cell); };
    if (settings.shards == 1) {
        remove_parts(folder, is_stale);
        remove_torn_files(folder, OwnedFiles(folder));
        return;
    }
    const std::set<std::string> mine = cells_of(plan, settings);
    remove_parts(folder, [&](const std::string& cell) { return is_stale(cell) && mine.contains(cell); });
}

Earlier earlier_results(const Plan& plan, const std::filesystem::path& folder, const RunSettings& settings,
                        std::ostream& messages) {
    const std::string shard = shard_name(settings);
    check_output_folder(folder, plan, settings);
    if (const std::string warning = check_parts(folder, plan, settings); !warning.empty()) {
        messages << warning << "\n";
    }
    if (!shard_files(folder, "manifest", ".json").empty() && format_of(folder) < folder_format) {
        adopt_derived_files(folder);
    }
    if (!settings.resume) {
        if (settings.overwrite) { remove_results(plan, folder, settings); }
        return {};
    }
    Earlier earlier{read_journals(folder, settings.build)};
    add_earlier_manifest(manifest_file(folder, shard), earlier);
    std::vector<std::string> damage = run_damage(folder);
    damage.insert(damage.end(), earlier.journals.complaints.begin(), earlier.journals.complaints.end());
    earlier.damaged = !damage.empty();
    for (const std::string& text : damage) { messages << text << "\n"; }
    if (const std::size_t again = foreign_cells(plan, earlier.journals, settings); again > 0) {
        messages << fmt::format("{} cells of another build are computed again\n", again);
    }
    mend_journal(journal_file(folder, shard));
    return earlier;
}

void check_output_folder(const std::filesystem::path& folder, const Plan& plan, const RunSettings& settings) {
    std::error_code error;
    if (std::filesystem::exists(folder, error) && !std::filesystem::is_directory(folder, error)) {
        throw UsageError(fmt::format("{}: expected a folder for the results, got a file", folder.string()));
    }
    check_parts(folder, plan, settings);
    if (settings.resume && is_unlisted(folder)) { return; }
    const OwnedFiles owned(folder);
    const bool used = settings.shards == 1 ? !owned.empty() && holds_results(folder)
                                           : std::filesystem::exists(journal_file(folder, shard_name(settings)), error);
    if (used && !settings.resume && !settings.overwrite) {
        throw UsageError(
            fmt::format("{}: this folder holds results already: --resume keeps what is valid and computes the "
                        "rest, --overwrite starts again",
                        folder.string()));
    }
    owned.require(would_write(plan, settings));
}

}  // namespace kreisel
