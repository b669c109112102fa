// SPDX-License-Identifier: BSD-3-Clause
//
// DIR/sums.sha256: the sums of results.csv, tables and figures, which have no room for one of their own,
// and of results.jsonl, whose lines have sums that do not tell of their order.
// `sha256sum -c sums.sha256` checks them too. Its last line is a comment with the sum of the others.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace kreisel {

inline constexpr const char* sum_list_name = "sums.sha256";

/// Of a file that is being written: it is ours, and not to be believed yet.
inline const std::string unfinished_sum(64, '0');

struct SumList {
    std::map<std::string, std::string> sums;  ///< by path below the folder
    std::string damage = "";                  ///< what is wrong with the list itself; empty: nothing

    bool has(const std::string& path) const { return sums.contains(path); }
};

/// Empty where there is no such file. Of a damaged one the lines that can be read. Throws FileError.
SumList read_sum_list(const std::filesystem::path& folder);

void write_sum_list(const std::filesystem::path& folder, const SumList& list);

/// The same list with the sums of these files as they are now; without those that are not there.
void record_sums(const std::filesystem::path& folder, const std::vector<std::string>& paths);
/// The same list in which these files are unfinished.
void announce_files(const std::filesystem::path& folder, const std::vector<std::string>& paths);

/// The same list without those of these files that are not there: they could not be written.
void withdraw_files(const std::filesystem::path& folder, const std::vector<std::string>& paths);

/// A text for each listed file that is not what the list says, and for a damaged list. Tables, figures and the report
/// need not be there.
std::vector<std::string> sum_list_damage(const std::filesystem::path& folder);

/// Whether text read from a file may become a path below a folder: relative, of plain names.
bool is_path_below(const std::string& path);

}  // namespace kreisel
