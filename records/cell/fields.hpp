// SPDX-License-Identifier: BSD-3-Clause
//
// The table of the members of a result line: JSON lines and results.csv are written and read by it.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "records/cell/record.hpp"

namespace kreisel {

enum class FieldPart { identity, outcome };

/// A result line is the same on every run; a line of a journal has the times as well.
enum class LineKind { result, journal };

struct RecordField {
    std::string name;  ///< member of a line
    FieldPart part;
    /// As JSON; empty: the record does not have it.
    std::function<std::string(const CellRecord&, LineKind)> write;
    /// Throws std::invalid_argument where the value does not fit.
    std::function<void(const JsonValue&, CellRecord&)> read;
    /// In results.csv: the title of a column, "h [s]", or where it ends with '.' or is "*" the prefix of a column for
    /// each member of the object, "option." ("*": none). Empty: JSON lines only.
    std::string column = "";
    bool is_text = false;  ///< whatever a column holds is text, also "12"
    /// What a result line has, given what the journal line of the same cell has; null: the same.
    std::string (*of_result)(std::string_view json) = nullptr;
};

/// In the order of a line.
const std::vector<RecordField>& record_fields();

/// The JSON of the members of a line, by the place of their field; empty where there is none.
using FieldValues = std::vector<std::string_view>;

}  // namespace kreisel
