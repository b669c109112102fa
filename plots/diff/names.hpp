// SPDX-License-Identifier: BSD-3-Clause
//
// How a comparison names cells and writes numbers.
#pragma once

#include <string>
#include <vector>

#include "records/diff/recorded_cell.hpp"

namespace kreisel {

/// For a terminal: hash, label of the problem, formulation, method with its options, projection with its options,
/// precision, steps, end.
std::vector<std::string> short_cell(const RecordedCell& cell);
const std::vector<std::string>& short_cell_columns();
/// The columns that are printed once if all cells agree.
std::vector<std::string> shared_cell_columns();

/// For a file: the same without the hash, options apart.
std::vector<std::string> full_cell(const RecordedCell& cell);
const std::vector<std::string>& full_cell_columns();

/// "1", "37.5", "2.1e+09"; "-" for 0.
std::string ulp_text(double ulps);
/// "1.15e-03"; "-" for 0.
std::string number_or_dash(double value);
std::string text_or_dash(const std::string& text);

}  // namespace kreisel
