// SPDX-License-Identifier: BSD-3-Clause
//
// SHA-256, for sums that other programs check too (sha256sum).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace kreisel {

/// 64 hexadecimal digits, lower case, as sha256sum prints them.
std::string sha256_text(std::string_view text);
/// The same of the bytes of a file. Throws FileError.
std::string sha256_of_file(const std::filesystem::path& file);
/// The 32 bytes themselves.
std::string sha256_bytes(std::string_view text);

}  // namespace kreisel
