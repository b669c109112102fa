// SPDX-License-Identifier: BSD-3-Clause
#include "records/folder/derived_files.hpp"

#include <fmt/format.h>

#include "records/manifest.hpp"
#include "records/sums/sum_list.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/sha256.hpp"

namespace kreisel {

void require_derived(const std::filesystem::path& folder, const std::vector<std::string>& paths) {
    if (format_of(folder) < folder_format) { return; }
    const SumList list = read_sum_list(folder);
    for (const std::string& path : paths) {
        std::error_code error;
        if (list.has(path) || !std::filesystem::exists(folder / path, error)) { continue; }
        throw FileError(
            fmt::format("{}: expected nothing at this name, or a file that sums.sha256 lists, got another "
                        "one; please move it away",
                        (folder / path).string()));
    }
}

void replace_derived(const std::filesystem::path& folder, const std::string& below,
                     const std::map<std::string, std::string>& texts) {
    std::vector<std::string> paths;
    for (const auto& [path, text] : texts) { paths.push_back(path); }
    require_derived(folder, paths);
    SumList list = read_sum_list(folder);
    for (auto entry = list.sums.begin(); entry != list.sums.end();) {
        const bool stale = entry->first.starts_with(below + "/") && !texts.contains(entry->first);
        std::error_code ignored;
        // An unfinished one may be of an older version, or of someone else: it may be written over, no more.
        if (stale && entry->second != unfinished_sum) { std::filesystem::remove(folder / entry->first, ignored); }
        entry = stale ? list.sums.erase(entry) : std::next(entry);
    }
    for (const auto& [path, text] : texts) { list.sums[path] = sha256_text(text); }
    write_sum_list(folder, list);
    make_folder(folder / below);
    for (const auto& [path, text] : texts) { write_atomically(folder / path, text); }
}

}  // namespace kreisel
