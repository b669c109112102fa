// SPDX-License-Identifier: BSD-3-Clause
#include "support/paths/at_path.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "support/errors.hpp"

namespace kreisel {

namespace {

std::string kind_of(mode_t mode) {
    switch (mode & S_IFMT) {
        case S_IFREG:
            return "";
        case S_IFDIR:
            return "a folder";
        case S_IFIFO:
            return "a named pipe";
        case S_IFSOCK:
            return "a socket";
        default:
            return "a device";
    }
}

// As mktemp makes it.
bool is_empty_file(const std::filesystem::path& file) {
    std::error_code error;
    return what_is_no_file(file).empty() && std::filesystem::file_size(file, error) == 0 && !error;
}

bool begins_with(const std::filesystem::path& file, std::string_view mark) {
    if (!what_is_no_file(file).empty()) { return false; }
    std::ifstream stream(file, std::ios::binary);
    std::string beginning(mark.size(), '\0');
    return stream.read(beginning.data(), static_cast<std::streamsize>(mark.size())) && beginning == mark;
}

}  // namespace

std::string what_is_no_file(const std::filesystem::path& path) {
    struct stat status = {};
    return ::stat(path.c_str(), &status) == 0 ? kind_of(status.st_mode) : "";
}

bool leads_to_file(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

bool is_taken(const std::filesystem::path& path) {
    struct stat status = {};
    return ::lstat(path.c_str(), &status) == 0;
}

void require_file(const std::filesystem::path& file) {
    const std::string kind = what_is_no_file(file);
    if (!kind.empty()) { throw FileError(fmt::format("{}: expected a file, got {}", file.string(), kind)); }
}

std::string which_is_no_file(const std::string& written, const std::filesystem::path& path) {
    const std::string kind = what_is_no_file(path);
    return fmt::format("{}, which is {}", written, kind.empty() ? "no file" : kind);
}

std::string why_not_writable(const std::filesystem::path& folder) {
    return ::faccessat(AT_FDCWD, folder.c_str(), W_OK, AT_EACCESS) == 0 ? "" : std::strerror(errno);
}

void require_own(const std::vector<std::filesystem::path>& files, const std::filesystem::path& witness,
                 std::string_view mark) {
    const auto taken = std::find_if(files.begin(), files.end(),
                                    [](const auto& file) { return is_taken(file) && !is_empty_file(file); });
    if (taken == files.end()) { return; }
    if (begins_with(witness, mark)) { return; }
    throw FileError(
        fmt::format("{}: expected nothing at this name, or what kreisel has written, got {}; please move it away, or "
                    "choose another name",
                    taken->string(), what_is_no_file(*taken).empty() ? "another file" : what_is_no_file(*taken)));
}

}  // namespace kreisel
