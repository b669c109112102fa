// SPDX-License-Identifier: BSD-3-Clause
//
// results.csv, made from the result lines only.
#pragma once

#include <string>
#include <vector>

namespace kreisel {

/// One row per line: the identity of the cell, its options and projection options, status and detail, metrics and
/// counts, each number with the digits of the line. Columns in order of first appearance within each group.
std::string results_table(const std::vector<std::string>& lines);

/// A field of a comma-separated file (RFC 4180): quoted if necessary.
std::string csv_field(const std::string& text);

}  // namespace kreisel
