// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/read_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <stdexcept>

#include "records/cell/fields.hpp"
#include "records/cell/line.hpp"
#include "records/cell/state_entries.hpp"
#include "support/csv.hpp"

namespace kreisel {

namespace {

/// "error.position" and "m" of "error.position [m]".
struct Title {
    std::string name, unit;
    explicit Title(const std::string& title) {
        const auto bracket = title.ends_with("]") ? title.rfind(" [") : std::string::npos;
        name = title.substr(0, bracket);
        if (bracket != std::string::npos) { unit = title.substr(bracket + 2, title.size() - bracket - 3); }
    }
};

/// What a field of the table is in a line of JSON.
JsonValue scalar(const std::string& text, bool always_text) {
    char* end = nullptr;
    std::strtod(text.c_str(), &end);
    const bool number = !always_text && *end == '\0', flag = !always_text && (text == "true" || text == "false");
    return {number ? JsonValue::Kind::number : flag ? JsonValue::Kind::flag : JsonValue::Kind::text, text, {}, {}};
}

/// The field of a column: the one of that title, else of its prefix, else the metrics.
const RecordField& field_of(const std::string& title) {
    const RecordField* metrics = nullptr;
    for (const RecordField& field : record_fields()) {
        if (field.column == title) { return field; }
        if (field.column.ends_with(".") && title.starts_with(field.column)) { return field; }
        if (field.column == "*") { metrics = &field; }
    }
    return *metrics;
}

JsonValue& member_of(JsonValue& object, const std::string& name) {
    object.kind = JsonValue::Kind::object;
    for (JsonMember& member : object.members) {
        if (member.name == name) { return member.value; }
    }
    return object.members.emplace_back(JsonMember{name, {}}).value;
}

/// Puts a value to its place: "mass", "lever.1" of a vector, "inertia.2.3" of a matrix.
void put(JsonValue& object, const std::string& path, const JsonValue& value) {
    const auto is_index = [](char c) { return c == '.' || (c >= '0' && c <= '9'); };
    std::size_t end = path.size();
    while (end > 1 && is_index(path[end - 1])) { --end; }
    const std::size_t dot = std::min(path.find('.', end), path.size());  // a name may end with digits
    JsonValue* place = &member_of(object, path.substr(0, dot));
    for (std::size_t at = dot; at < path.size(); at = std::min(path.find('.', at + 1), path.size())) {
        std::size_t index = 0;
        std::from_chars(path.data() + at + 1, path.data() + path.size(), index);
        if (index < 1 || index > place->elements.size() + 1) { throw std::invalid_argument("an element is missing"); }
        place->kind = JsonValue::Kind::list;
        place->elements.resize(std::max(place->elements.size(), index));
        place = &place->elements[index - 1];
    }
    *place = value;
}

/// One row as a line of JSON, and the numbers of its final state.
class RowReader {
  public:
    void add(const std::string& column, const std::string& text) {
        if (text.empty()) { return; }
        const RecordField& field = field_of(column);
        const Title title(column);
        const JsonValue value = scalar(text, field.is_text);
        if (field.column == column) {
            member_of(line_, field.name) = value;
        } else if (field.column == "*") {
            member_of(member_of(line_, field.name), title.name) = value;
        } else if (field.name == "final") {
            final_.push_back({title.name.substr(field.column.size()), "", title.unit, {value.number(), text}});
        } else {
            put(member_of(line_, field.name), title.name.substr(field.column.size()), value);
        }
    }
    CellRecord record() const {
        CellRecord record = read_record(line_);
        if (!final_.empty()) { record.outcome.final = state_of(final_); }
        return record;
    }

  private:
    JsonValue line_;
    std::vector<StateEntry> final_;
};

}  // namespace

std::vector<CellRecord> read_results_table(const std::string& text) {
    const auto rows = read_csv(text);
    std::vector<CellRecord> records;
    for (std::size_t row = 1; row < rows.size(); ++row) {
        std::string title;
        try {
            if (rows[row].size() != rows[0].size()) { throw std::invalid_argument("wrong number of fields"); }
            RowReader reader;
            for (std::size_t i = 0; i < rows[row].size(); ++i) { reader.add(title = rows[0][i], rows[row][i]); }
            title.clear();
            records.push_back(reader.record());
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(
                fmt::format("row {}, {}: {}", row, title.empty() ? "its whole" : title, error.what()));
        }
    }
    return records;
}

}  // namespace kreisel
