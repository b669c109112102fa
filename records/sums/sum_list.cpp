// SPDX-License-Identifier: BSD-3-Clause
#include "records/sums/sum_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "support/files.hpp"
#include "support/hash.hpp"
#include "support/paths/at_path.hpp"
#include "support/sha256.hpp"

namespace kreisel {

namespace {

constexpr std::size_t sum_digits = 64;

std::string entries_text(const SumList& list) {
    std::string text;
    for (const auto& [path, sum] : list.sums) { text += fmt::format("{}  {}\n", sum, path); }
    return text;
}

std::string last_comment(const std::string& entries) { return fmt::format("# sum {}\n", hash_text(entries)); }

bool is_entry(const std::string& line) {
    return line.size() > sum_digits + 2 && line.find_first_not_of("0123456789abcdef") == sum_digits &&
           line.compare(sum_digits, 2, "  ") == 0 && is_path_below(line.substr(sum_digits + 2));
}

// What `table`, `plot` and `report` write can be made again at any time.
bool is_of_run(const std::string& path) {
    return path == "results.jsonl" || path == "results.csv" || path == "geometry.json";
}

bool is_file(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
}

}  // namespace

bool is_path_below(const std::string& path) {
    if (path.empty() || path.find('\0') != std::string::npos) { return false; }
    const std::filesystem::path parts(path);
    return parts.is_relative() && path == parts.lexically_normal().string() && parts.has_filename() &&
           std::none_of(parts.begin(), parts.end(), [](const auto& part) { return part == ".." || part == "."; });
}

SumList read_sum_list(const std::filesystem::path& folder) {
    const auto file = folder / sum_list_name;
    SumList list;
    if (const std::string kind = what_is_no_file(file); !kind.empty()) {
        list.damage = fmt::format("{}: damaged: expected a file, got {}", file.string(), kind);
    }
    if (!is_file(file)) { return list; }
    const std::string text = read_text(file);
    std::istringstream lines(text);
    long number = 0, bad = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.starts_with("#")) { continue; }
        if (is_entry(line)) {
            list.sums[line.substr(sum_digits + 2)] = line.substr(0, sum_digits);
        } else if (bad == 0) {
            bad = number;
        }
    }
    const std::string entries = entries_text(list);
    if (text != entries + last_comment(entries)) {
        list.damage = fmt::format("{}:{}: damaged: its own sum does not hold", file.string(),
                                  std::max(bad > 0 ? bad : number, 1L));
    }
    return list;
}

void write_sum_list(const std::filesystem::path& folder, const SumList& list) {
    const std::string entries = entries_text(list);
    write_atomically(folder / sum_list_name, entries + last_comment(entries));
}

namespace {

// Of a list whose own sum does not hold any line may be wrong: a file that differs from its line counts as unfinished.
SumList list_to_change(const std::filesystem::path& folder) {
    SumList list = read_sum_list(folder);
    if (list.damage.empty()) { return list; }
    for (auto& [path, sum] : list.sums) {
        if (!is_file(folder / path) || sha256_of_file(folder / path) != sum) { sum = unfinished_sum; }
    }
    return list;
}

}  // namespace

void record_sums(const std::filesystem::path& folder, const std::vector<std::string>& paths) {
    SumList list = list_to_change(folder);
    for (const std::string& path : paths) {
        if (is_file(folder / path)) {
            list.sums[path] = sha256_of_file(folder / path);
        } else {
            list.sums.erase(path);
        }
    }
    write_sum_list(folder, list);
}

void announce_files(const std::filesystem::path& folder, const std::vector<std::string>& paths) {
    SumList list = list_to_change(folder);
    for (const std::string& path : paths) { list.sums[path] = unfinished_sum; }
    write_sum_list(folder, list);
}

void withdraw_files(const std::filesystem::path& folder, const std::vector<std::string>& paths) {
    SumList list = list_to_change(folder);
    for (const std::string& path : paths) {
        if (!is_file(folder / path)) { list.sums.erase(path); }
    }
    write_sum_list(folder, list);
}

std::vector<std::string> sum_list_damage(const std::filesystem::path& folder) {
    const SumList list = read_sum_list(folder);
    if (!list.damage.empty()) { return {list.damage}; }
    std::vector<std::string> damage;
    for (const auto& [path, sum] : list.sums) {
        const auto file = folder / path;
        if (sum == unfinished_sum) { continue; }
        if (const std::string kind = what_is_no_file(file); !kind.empty()) {
            damage.push_back(fmt::format("{}: damaged: expected a file, got {}", file.string(), kind));
            continue;
        }
        if (!is_file(file)) {
            if (is_of_run(path)) { damage.push_back(fmt::format("{}: damaged: it is not there", file.string())); }
            continue;
        }
        if (sha256_of_file(file) == sum) { continue; }
        damage.push_back(fmt::format("{}: damaged: it is not what sums.sha256 says", file.string()));
    }
    return damage;
}

}  // namespace kreisel
