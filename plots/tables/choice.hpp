// SPDX-License-Identifier: BSD-3-Clause
//
// One table as a paper wants it: chosen columns and rows, under names that read well.
#pragma once

#include <string>
#include <vector>

#include "plots/tables/table.hpp"

namespace kreisel {

/// Titles of columns may be given without their unit.
struct TableChoice {
    std::string table;                      ///< the name of its files, such as "errors"
    std::vector<std::string> columns = {};  ///< in this order; empty: all
    /// "COLUMN=PATTERN": rows with such a text there, "*" for any characters. Those of one column are alternatives.
    std::vector<std::string> rows = {};
    std::vector<std::string> names = {};  ///< "TEXT=NAME": how titles and texts are printed; the last "=" counts
    std::string format = "text";          ///< one of table_formats()
};

const std::vector<std::string>& table_formats();

/// The table with all rows of its CSV file, whose long numbers are rounded except in CSV. Throws UsageError, with what
/// was expected, for tables and columns that these results do not have, and where no row is left.
std::string chosen_table(const Results& results, const TableChoice& choice);

}  // namespace kreisel
