// SPDX-License-Identifier: BSD-3-Clause
//
// Parameters and options of cells as figures select them: by the names of their columns in results.csv.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// "parameter.", "option." and "projection_option.", which a name follows.
const std::vector<std::string>& cell_value_families();
bool is_cell_value(const std::string& key);

/// A text as it is, other values as JSON with numbers in their shortest form.
std::string cell_value_text(const JsonValue& value);
/// Nothing where the cell has none of that name.
std::optional<std::string> cell_value(const ResultRow& row, const std::string& key);

}  // namespace kreisel
