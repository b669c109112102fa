// SPDX-License-Identifier: BSD-3-Clause
//
// The tables of a folder as data of the page.
#pragma once

#include <filesystem>
#include <string>

#include "records/results.hpp"

namespace kreisel {

/// A list of tables (plots/report/column_table.hpp): all cells, then what `kreisel table` writes, as far as there is
/// room; of one without {"name", "title", "left_out": true}. Some two thirds of the largest page are tables.
std::string report_tables(const Results& results);

}  // namespace kreisel
