// SPDX-License-Identifier: BSD-3-Clause
//
// Tables of the report by column: what repeats is written once.
#pragma once

#include <string>
#include <vector>

#include "plots/tables/text.hpp"

namespace kreisel {

/// A table in which numbers stay as they are written: 36 digits are 36 digits.
struct ColumnTable {
    struct Column {
        std::string title;  ///< with the unit: "h [s]"
        std::vector<std::string> texts;
        bool is_text = false;  ///< also "12" is a text
    };
    std::string name, title;
    std::vector<Column> columns;
    std::vector<std::string> notes = {};
};

ColumnTable by_columns(const TextTable& table);

/// {"name", "title", "notes", "rows": number of them, "columns": [...]}. A column has a "title" and either "same", the
/// value of all rows, or "numbers" (null: absent; a text where a double does not hold its digits), or "texts" with the
/// "index" of the one of each row.
std::string json_value(const ColumnTable& table);

}  // namespace kreisel
