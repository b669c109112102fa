// SPDX-License-Identifier: BSD-3-Clause
#include "records/folder/damage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "records/cell/record.hpp"
#include "records/journal.hpp"
#include "records/reference_store.hpp"
#include "records/sums/sum_list.hpp"
#include "records/trajectory_file.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

bool is_found(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::exists(file, error);
}

std::string not_there(const std::filesystem::path& file) {
    const std::string kind = what_is_no_file(file);
    return fmt::format("{}: damaged: {}", file.string(),
                       kind.empty() ? "it is not there" : "expected a file, got " + kind);
}

std::filesystem::path journal_of(const std::filesystem::path& manifest) {
    std::string name = manifest.filename().string();
    name.replace(0, std::string_view("manifest").size(), "journal");
    return manifest.parent_path() / (name + "l");
}

// The manifest is written before its journal.
std::vector<std::string> missing_manifests(const std::filesystem::path& folder) {
    std::vector<std::string> damage;
    for (const auto& journal : shard_files(folder, "journal", ".jsonl")) {
        std::string name = journal.filename().string();
        name.replace(0, std::string_view("journal").size(), "manifest").pop_back();
        if (!is_found(folder / name)) { damage.push_back(not_there(folder / name)); }
    }
    return damage;
}

// It is written before what it lists.
std::string missing_sum_list(const std::filesystem::path& folder) {
    const auto file = folder / sum_list_name;
    const bool wanted = format_of(folder) >= folder_format && is_found(folder / "results.csv");
    return wanted && !is_found(file) ? not_there(file) : "";
}

// What a run that has ended says of its journal: nothing is appended before another run has said that it begins.
std::string changed_journal(const std::filesystem::path& manifest_path, const ManifestState& state) {
    const auto journal = journal_of(manifest_path);
    if (!state.journal) { return ""; }
    std::error_code error;
    if (!std::filesystem::is_regular_file(journal, error)) { return not_there(journal); }
    const std::uintmax_t size = std::filesystem::file_size(journal, error);
    const bool ends_in_line = size == 0 || LineFile(journal).line(size - 1, 1) == "\n";
    if (size == *state.journal && ends_in_line) { return ""; }
    const std::string text = read_text(journal);
    const auto known = text.begin() + static_cast<std::ptrdiff_t>(std::min<std::uintmax_t>(size, *state.journal));
    const char* fault = size < *state.journal   ? "its end is missing"
                        : size > *state.journal ? "something has been added"
                                                : "its last line is torn";
    return fmt::format("{}:{}: damaged: expected {} bytes, got {}: {}", journal.string(),
                       std::count(text.begin(), known, '\n') + 1, *state.journal, text.size(), fault);
}

}  // namespace

std::vector<std::string> run_damage(const std::filesystem::path& folder) {
    std::vector<std::string> damage = missing_manifests(folder);
    for (const auto& file : shard_files(folder, "manifest", ".json")) {
        try {
            const std::string journal = changed_journal(file, read_manifest(file).state);
            if (!journal.empty()) { damage.push_back(journal); }
        } catch (const FileError& error) { damage.emplace_back(error.what()); } catch (const UsageError&) {
            continue;
        }  // of someone else
    }
    for (std::string& text : reference_damage(folder)) { damage.push_back(std::move(text)); }
    return damage;
}

std::vector<std::string> folder_damage(const std::filesystem::path& folder) {
    std::vector<std::string> damage = run_damage(folder);
    for (std::string& text : journal_damage(folder)) { damage.push_back(std::move(text)); }
    if (std::string missing = missing_sum_list(folder); !missing.empty()) { damage.push_back(std::move(missing)); }
    for (std::string& text : sum_list_damage(folder)) { damage.push_back(std::move(text)); }
    return damage;
}

std::string trajectory_damage(const std::filesystem::path& folder, const std::string& cell, const std::string& sum) {
    const auto file = folder / trajectory_file(cell);
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) { return not_there(file); }
    if (sum_of_trajectory(file) == sum) { return ""; }
    return fmt::format("{}: damaged: its sum is not the one of its cell", file.string());
}

std::string format_warning(const std::filesystem::path& folder) {
    return fmt::format("{}: warning: written by an older version, without check sums: damage cannot be noticed",
                       folder.string());
}

std::string missing_lines(const std::filesystem::path& file, std::size_t lines, const ManifestContents& manifest) {
    const ManifestState& state = manifest.state;
    if (manifest.format < folder_format || state.ended.empty()) { return ""; }
    const std::size_t expected = state.counts.total - state.counts.missing;
    if (lines >= expected) { return ""; }
    return fmt::format("{}:{}: damaged: expected {} lines, got {}", file.string(), lines + 1, expected, lines);
}

}  // namespace kreisel
