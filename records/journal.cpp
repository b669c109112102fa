// SPDX-License-Identifier: BSD-3-Clause
#include "records/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "support/errors.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

// Limits the messages about a badly damaged file.
constexpr std::size_t most_complaints = 10;

void complain(JournalContents& contents, std::string text) {
    if (contents.complaints.size() < most_complaints) {
        contents.complaints.push_back(std::move(text));
    } else if (contents.complaints.size() == most_complaints) {
        contents.complaints.emplace_back("further journal lines are left out too");
    }
}

void read_journal(const std::filesystem::path& file, const std::string& build, JournalContents& contents) {
    const std::string text = read_text(file);
    long number = 0;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = text.find('\n', start);
        ++number;
        if (end == std::string::npos) {
            complain(contents, fmt::format("{}:{}: torn last line left out", file.string(), number));
            return;
        }
        const std::string line = text.substr(start, end - start);
        start = end + 1;
        auto cell = read_journal_line(line);
        if (cell && cell->record.outcome.status == status::interrupted) {
            contents.interrupted.insert(std::move(cell->record.identity.cell));
        } else if (cell && (build.empty() || cell->build == build)) {
            const std::string& name = cell->record.identity.cell;
            contents.builds.insert_or_assign(name, std::move(cell->build));
            contents.cells.insert_or_assign(name, std::move(cell->record));
        } else if (cell) {
            contents.foreign.insert(std::move(cell->record.identity.cell));
        } else {
            complain(contents, fmt::format("{}:{}: damaged line left out", file.string(), number));
        }
    }
}

}  // namespace

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

void mend_journal(const std::filesystem::path& journal) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(journal, error)) { return; }
    const std::string text = read_text(journal);
    const auto last = text.rfind('\n');
    const std::size_t whole = last == std::string::npos ? 0 : last + 1;
    if (whole == text.size()) { return; }
    std::filesystem::resize_file(journal, whole, error);
    if (error) {
        throw FileError(fmt::format("{}: its torn last line cannot be removed: {}", journal.string(), error.message()));
    }
}

void prune_journal(const std::filesystem::path& journal, const std::string& build) {
    std::istringstream lines(read_text(journal));
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        if (read_journal_line(line, build)) { kept += line + "\n"; }
    }
    write_atomically(journal, kept);
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
