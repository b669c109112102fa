// SPDX-License-Identifier: BSD-3-Clause
//
// Comma-separated files (RFC 4180).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kreisel {

/// A field: quoted if necessary.
std::string csv_field(const std::string& text);
/// Appends it to a row that is made.
void append_csv_field(std::string& row, std::string_view text);

/// The fields of each row. Throws std::invalid_argument where a quoted field does not end.
std::vector<std::vector<std::string>> read_csv(const std::string& text);

}  // namespace kreisel
