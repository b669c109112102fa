// SPDX-License-Identifier: BSD-3-Clause
//
// What is at a path, before something is read or written there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace kreisel {

/// Throws FileError, which says what it is, where a name is that of a folder, a named pipe or a device: opening a pipe
/// that nobody writes to waits for ever. All that reads files below requires it.
void require_file(const std::filesystem::path& file);
/// What is at a name that is not a file: "a folder", "a named pipe", ...; empty for a file, and where there is nothing.
std::string what_is_no_file(const std::filesystem::path& path);
/// The same in a sentence about what must be a file, `PATH, which is a folder`, or `no file` where there is nothing.
std::string which_is_no_file(const std::string& written, const std::filesystem::path& path);
/// Whether there is a file at the end of a path; not so where links lead in a circle, or no right to look is given.
bool leads_to_file(const std::filesystem::path& path);
/// Whether anything is at a name, be it a link that leads nowhere.
bool is_taken(const std::filesystem::path& path);
/// Why nothing can be written into a folder; empty if something can.
std::string why_not_writable(const std::filesystem::path& folder);

/// Throws FileError where one of the `files`, which are written together, is there already, with something in it, and
/// is not of kreisel. The `witness` among them, or beside them, tells by how it begins: every one that kreisel has
/// written does so with `mark`.
void require_own(const std::vector<std::filesystem::path>& files, const std::filesystem::path& witness,
                 std::string_view mark);

}  // namespace kreisel
