// SPDX-License-Identifier: BSD-3-Clause
#include "records/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "records/sums/summed_text.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

// Limits the messages about a badly damaged file.
constexpr std::size_t most_complaints = 10;

void complain(std::vector<std::string>& complaints, std::string text) {
    if (complaints.size() < most_complaints) {
        complaints.push_back(std::move(text));
    } else if (complaints.size() == most_complaints) {
        complaints.emplace_back("further journal lines are left out too");
    }
}

std::string damaged_line(const std::filesystem::path& file, long number) {
    return fmt::format("{}:{}: damaged line left out", file.string(), number);
}

void read_line(const std::string& line, const JournalPlace& place, long number, const std::string& build,
               JournalContents& contents) {
    auto cell = read_journal_line(line);
    if (!cell) { return complain(contents.complaints, damaged_line(contents.files[place.file], number)); }
    std::string& name = cell->record.identity.cell;
    if (cell->record.outcome.status == status::interrupted) {
        contents.interrupted.insert(std::move(name));
    } else if (build.empty() || cell->build == build) {
        contents.cells.insert_or_assign(std::move(name), place);
    } else {
        contents.foreign.insert(std::move(name));
    }
}

void read_journal(const std::filesystem::path& file, const std::string& build, JournalContents& contents) {
    const auto index = static_cast<std::uint32_t>(contents.files.size());
    contents.files.push_back(file);
    long number = 0;
    const bool whole = for_each_line(file, [&](std::uint64_t begin, const std::string& line) {
        read_line(line, {index, static_cast<std::uint32_t>(line.size()), begin}, ++number, build, contents);
    });
    if (!whole) {
        complain(contents.complaints, fmt::format("{}:{}: torn last line left out", file.string(), number + 1));
    }
}

}  // namespace

std::uint32_t JournalLines::add(const std::filesystem::path& journal) {
    files_.push_back(journal);
    return static_cast<std::uint32_t>(files_.size() - 1);
}

std::string JournalLines::line(const JournalPlace& place) const {
    std::string line = text_at(place);
    if (sum_state(line) != SumState::holds) { fail_changed(place); }
    return line;
}

std::string JournalLines::text_at(const JournalPlace& place) const {
    if (!open_ || number_ != place.file) {
        open_.emplace(files_.at(place.file));
        number_ = place.file;
    }
    return open_->line(place.begin, place.size);
}

CellRecord JournalLines::record(const JournalPlace& place) const {
    auto cell = read_journal_line(text_at(place));
    if (!cell) { fail_changed(place); }
    return std::move(cell->record);
}

void JournalLines::fail_changed(const JournalPlace& place) const {
    throw FileError(fmt::format("{}: has changed while it was read", files_.at(place.file).string()));
}

JournalLines JournalContents::lines() const {
    JournalLines lines;
    for (const auto& file : files) { lines.add(file); }
    return lines;
}

std::filesystem::path journal_file(const std::filesystem::path& folder, const std::string& shard) {
    return folder / (shard.empty() ? "journal.jsonl" : "journal." + shard + ".jsonl");
}

std::vector<std::filesystem::path> files_like(const std::filesystem::path& folder, const std::string& stem,
                                              const std::string& extension) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(stem) && name.ends_with(extension)) { files.push_back(entry.path()); }
    }
    if (error && error != std::errc::no_such_file_or_directory) {
        throw FileError(fmt::format("{}: cannot be read: {}", folder.string(), error.message()));
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::filesystem::path> shard_files(const std::filesystem::path& folder, const std::string& stem,
                                               const std::string& extension) {
    static const std::regex shard(R"(\.[0-9]+-of-[0-9]+)");
    auto files = files_like(folder, stem, extension);
    std::erase_if(files, [&](const std::filesystem::path& file) {
        const std::string name = file.filename().string();
        const std::string between = name.substr(stem.size(), name.size() - stem.size() - extension.size());
        return !between.empty() && !std::regex_match(between, shard);
    });
    return files;
}

JournalContents read_journals(const std::filesystem::path& folder, const std::string& build) {
    JournalContents contents;
    for (const auto& file : shard_files(folder, "journal", ".jsonl")) { read_journal(file, build, contents); }
    const auto is_done = [&](const std::string& hash) { return contents.cells.contains(hash); };
    std::erase_if(contents.foreign, is_done);
    std::erase_if(contents.interrupted, is_done);
    return contents;
}

std::vector<std::string> journal_damage(const std::filesystem::path& folder) {
    std::vector<std::string> damage;
    for (const auto& file : shard_files(folder, "journal", ".jsonl")) {
        long number = 0;
        try {
            for_each_line(file, [&](std::uint64_t, const std::string& line) {
                ++number;
                if (sum_state(line) != SumState::holds) { complain(damage, damaged_line(file, number)); }
            });
        } catch (const FileError& error) { damage.emplace_back(error.what()); }
    }
    return damage;
}

void mend_journal(const std::filesystem::path& journal) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(journal, error)) { return; }
    std::uint64_t whole = 0;
    const bool ends =
        for_each_line(journal, [&](std::uint64_t begin, const std::string& line) { whole = begin + line.size() + 1; });
    if (ends) { return; }
    std::filesystem::resize_file(journal, whole, error);
    if (error) {
        throw FileError(fmt::format("{}: its torn last line cannot be removed: {}", journal.string(), error.message()));
    }
}

void prune_journal(const std::filesystem::path& journal, const std::string& build) {
    AtomicFile kept(journal);
    for_each_line(journal, [&](std::uint64_t, const std::string& line) {
        if (read_journal_line(line, build)) { kept.add(line + "\n"); }
    });
    kept.keep();
}

bool holds_journal(const std::filesystem::path& folder) {
    for (const auto& file : shard_files(folder, "journal", ".jsonl")) {
        std::error_code error;
        if (std::filesystem::is_regular_file(file, error) && std::filesystem::file_size(file, error) > 0) {
            return true;
        }
    }
    return false;
}

}  // namespace kreisel
