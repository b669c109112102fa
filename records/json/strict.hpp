// SPDX-License-Identifier: BSD-3-Clause
//
// JSON read strictly: what a lenient reader silently accepts is an error here.
#pragma once

#include <filesystem>
#include <string>

#include "records/json/diagnostics.hpp"

namespace kreisel {

inline constexpr int deepest_nesting = 64;
inline constexpr std::size_t largest_document = 8U << 20U;  // bytes

/// Parses RFC 8259 text. Throws UsageError, with a message that names the place, on a byte order mark, on text that is
/// not UTF-8, on duplicate keys, on nesting deeper than 64, on numbers beyond the range of double, on anything after
/// the value, and on more than 8 MB.
Document parse_document(std::string file, std::string text);

/// The same for a file. Throws UsageError also if it cannot be read.
Document read_document(const std::filesystem::path& file);

}  // namespace kreisel
