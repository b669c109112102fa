// SPDX-License-Identifier: BSD-3-Clause
//
// Files that are made from results: tables and figures. sums.sha256 lists them; what it does not list is not ours.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace kreisel {

/// Throws FileError if there is a file, at one of these names below the folder, that is not listed. Where an older
/// version has made the folder it lists nothing, and its files are ours by their names.
void require_derived(const std::filesystem::path& folder, const std::vector<std::string>& paths);

/// Writes texts by path, and removes what is listed below `below`, a folder, and not among them.
void replace_derived(const std::filesystem::path& folder, const std::string& below,
                     const std::map<std::string, std::string>& texts);

}  // namespace kreisel
