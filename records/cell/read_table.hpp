// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "records/cell/record.hpp"

namespace kreisel {

/// The records of a results.csv, as far as it holds them. Throws std::invalid_argument, with row and title, where a
/// value does not fit.
std::vector<CellRecord> read_results_table(const std::string& text);

}  // namespace kreisel
