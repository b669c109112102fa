// SPDX-License-Identifier: BSD-3-Clause
#include "records/folder/owned_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "records/cell/record.hpp"
#include "records/geometry.hpp"
#include "records/journal.hpp"
#include "records/manifest.hpp"
#include "records/sums/sum_list.hpp"
#include "records/trajectory_file.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

constexpr std::string_view part_ending = ".part";
const std::string any_trajectory = "trajectories/*.csv", any_reference = "references/*.json";

/// Whether a pattern names a path: the asterisk stands for the name of a cell.
bool names(const std::string& pattern, const std::string& path) {
    const auto asterisk = pattern.find('*');
    if (asterisk == std::string::npos) { return pattern == path; }
    const std::string before = pattern.substr(0, asterisk), after = pattern.substr(asterisk + 1);
    if (path.size() <= before.size() + after.size() || !path.starts_with(before) || !path.ends_with(after)) {
        return false;
    }
    return is_cell_name(path.substr(before.size(), path.size() - before.size() - after.size()));
}

std::string shard_of(const std::filesystem::path& manifest) {
    const std::string name = manifest.stem().string();  // "manifest", "manifest.1-of-2"
    const auto dot = name.find('.');
    return dot == std::string::npos ? "" : name.substr(dot + 1);
}

bool is_there(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
}

/// Also a link that leads nowhere.
void remove_file(const std::filesystem::path& file) {
    std::error_code error;
    std::filesystem::remove(file, error);
    if (error) { throw FileError(fmt::format("{}: cannot be removed: {}", file.string(), error.message())); }
}

std::vector<std::filesystem::path> trajectories_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> all = files_like(folder / "trajectories", "", ".csv");
    for (auto& part : trajectory_parts(folder)) { all.push_back(std::move(part)); }
    return all;
}

}  // namespace

std::vector<std::string> files_of_run(const std::string& shard, bool samples, bool references) {
    std::vector<std::string> files = {manifest_file("", shard).string(), journal_file("", shard).string()};
    if (shard.empty()) {
        for (const char* name : {"results.jsonl", "results.csv", "sums.sha256"}) { files.emplace_back(name); }
        if (samples) { files.emplace_back(geometry_file); }
    }
    if (samples) { files.push_back(any_trajectory); }
    if (references) { files.push_back(any_reference); }
    return files;
}

OwnedFiles::OwnedFiles(const std::filesystem::path& folder, bool all, const std::string& shard) : folder_(folder) {
    for (const auto& file : shard_files(folder, "manifest", ".json")) {
        if (!all && file != manifest_file(folder, shard)) { continue; }
        try {
            const ManifestContents manifest = read_manifest(file);
            const auto listed =
                manifest.format < folder_format ? files_of_run(shard_of(file), true, true) : manifest.state.files;
            files_.insert(files_.end(), listed.begin(), listed.end());
            // Also where one of a part has been given this name.
            files_.push_back(file.filename().string());
        } catch (const UsageError&) { continue; }  // not a manifest of kreisel
    }
}

bool OwnedFiles::has(const std::string& path) const {
    return std::any_of(files_.begin(), files_.end(), [&](const std::string& pattern) { return names(pattern, path); });
}

void OwnedFiles::require(const std::vector<std::string>& paths) const {
    for (const std::string& path : paths) {
        const std::string kind = what_is_no_file(folder_ / path);
        if ((!is_there(folder_ / path) && (kind.empty() || kind == "a device")) || has(path)) { continue; }
        throw UsageError(
            fmt::format("{}: expected nothing at this name, or a file that a manifest of this folder "
                        "lists, got another one; please move it away",
                        (folder_ / path).string()));
    }
}

void OwnedFiles::remove_results(const std::string& shard,
                                const std::function<bool(const std::string& cell)>& mine) const {
    const auto manifests = shard_files(folder_, "manifest", ".json");
    const auto is_manifest = [&](const std::filesystem::path& file) {
        return std::find(manifests.begin(), manifests.end(), file) != manifests.end();
    };
    for (const std::string& pattern : files_) {
        const bool kept = pattern == sum_list_name || is_manifest(folder_ / pattern);
        if (pattern.find('*') == std::string::npos && !kept) { remove_file(folder_ / pattern); }
    }
    for (const auto& file : trajectories_in(folder_)) {
        std::string path = "trajectories/" + file.filename().string();
        if (path.ends_with(part_ending)) { path.resize(path.size() - part_ending.size()); }
        if (has(path) && mine(std::filesystem::path(path).stem().string())) { remove_file(file); }
    }
    if (is_there(folder_ / sum_list_name)) { withdraw_files(folder_, {"results.jsonl", "results.csv", geometry_file}); }
    const auto kept = manifest_file(folder_, shard);
    for (const auto& manifest : manifests) {
        if (manifest == kept || !has(manifest.filename().string())) { continue; }
        if (!is_taken(kept)) { std::filesystem::rename(manifest, kept); }
        remove_file(manifest);
    }
}

void remove_parts(const std::filesystem::path& folder, const std::function<bool(const std::string& cell)>& stale) {
    for (const auto& file : trajectory_parts(folder)) {
        const std::string cell = file.stem().stem().string();
        if (is_there(file) && is_cell_name(cell) && stale(cell)) { remove_file(file); }
    }
}

void remove_torn_files(const std::filesystem::path& folder, const OwnedFiles& owned) {
    for (const char* below : {"", "references", "trajectories"}) {
        for (const auto& file : files_like(folder / below, "", ".part")) {
            // write_atomically: NAME.PID.part
            const auto numbered = file.stem();
            const std::string number = numbered.extension().string();
            const auto path = std::filesystem::path(below) / numbered.stem();
            const bool ours = number.size() > 1 && number.find_first_not_of("0123456789", 1) == std::string::npos;
            if (ours && owned.has(path.string())) { remove_file(file); }
        }
    }
}

void adopt_derived_files(const std::filesystem::path& folder) {
    const SumList list = read_sum_list(folder);
    std::vector<std::string> paths;
    const std::pair<const char*, std::vector<std::string>> derived[] = {{"tables", {".md", ".csv", ".tex"}},
                                                                        {"figures", {".pdf", ".svg", ".png"}}};
    for (const auto& [below, endings] : derived) {
        for (const std::string& ending : endings) {
            for (const auto& file : files_like(folder / below, "", ending)) {
                const std::string path = fmt::format("{}/{}", below, file.filename().string());
                if (!list.has(path) && is_path_below(path)) { paths.push_back(path); }
            }
        }
    }
    if (!paths.empty()) { announce_files(folder, paths); }
}

}  // namespace kreisel
