// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/table.hpp"

#include <algorithm>

#include "records/cell/fields.hpp"
#include "records/cell/state_entries.hpp"
#include "support/csv.hpp"

namespace kreisel {

namespace {

/// Titles and texts of one row.
using RowCells = std::vector<std::pair<std::string, std::string>>;

/// The cells of one field of a record.
class FieldCells {
  public:
    FieldCells(const RecordField& field, const CellRecord& record, const TableUnits& units)
        : field_(field), record_(record), units_(units) {}

    RowCells cells() {
        if (field_.column == "final.") {
            add_final_state();
        } else if (const std::string text = field_.write(record_, LineKind::result); !text.empty()) {
            add_field(parse_exactly(text));
        }
        return std::move(cells_);
    }

  private:
    void add_final_state() {
        const auto& final = record_.outcome.final;
        if (!final || final->bodies.size() > most_bodies_in_table) { return; }
        for (const StateEntry& entry : state_entries(*final)) {
            add("final." + entry.name, entry.unit, entry.number.text);
        }
    }

    void add_field(const JsonValue& value) {
        if (!value.is_object()) { return add(field_.column, "", value.text); }
        const std::string prefix = field_.column == "*" ? "" : field_.column;
        for (const JsonMember& member : value.members) {
            add_value(prefix + member.name, unit_of(member.name), member.value);
        }
    }

    /// A scalar, or the numbers of a vector or matrix; lists of bodies, joints and forces are in JSON lines only.
    void add_value(const std::string& name, const std::string& unit, const JsonValue& value) {
        if (value.is_scalar()) { add(name, unit, value.text); }
        for (std::size_t i = 0; i < value.elements.size(); ++i) {
            add_value(name + "." + std::to_string(i + 1), unit, value.elements[i]);
        }
    }

    std::string unit_of(const std::string& name) const {
        if (field_.column == "*") { return metric_unit(name, units_.metrics); }
        if (field_.column != "parameter.") { return ""; }
        const auto problem = units_.parameters.find(record_.identity.problem);
        if (problem == units_.parameters.end()) { return ""; }
        const auto unit = problem->second.find(name);
        return unit == problem->second.end() ? "" : unit->second;
    }

    void add(const std::string& name, const std::string& unit, const std::string& text) {
        cells_.emplace_back(unit.empty() ? name : name + " [" + unit + "]", text);
    }

    const RecordField& field_;
    const CellRecord& record_;
    const TableUnits& units_;
    RowCells cells_;
};

/// The fields that have columns, in the order of these.
std::vector<const RecordField*> column_fields() {
    std::vector<const RecordField*> fields;
    for (const RecordField& field : record_fields()) {
        if (!field.column.empty()) { fields.push_back(&field); }
    }
    std::stable_partition(fields.begin(), fields.end(), [](const auto* field) { return field->column != "final."; });
    return fields;
}

void append_field(std::string& line, const std::string& text) { line += (line.empty() ? "" : ",") + csv_field(text); }

}  // namespace

ResultsTable::ResultsTable(TableUnits units) : units_(std::move(units)) {
    for (const RecordField* field : column_fields()) { groups_.push_back({field}); }
}

std::size_t ResultsTable::place_of(Group& group, const std::string& title, std::size_t expected) {
    if (expected < group.titles.size() && group.titles[expected] == title) { return expected; }
    const auto known = group.places.find(title);
    if (known != group.places.end()) { return known->second; }
    group.titles.push_back(title);
    ++columns_;
    return group.places[title] = group.titles.size() - 1;
}

std::string ResultsTable::header() const {
    std::string line;
    for (const Group& group : groups_) {
        for (const std::string& title : group.titles) { append_field(line, title); }
    }
    return line + "\n";
}

std::string ResultsTable::row(const CellRecord& record) {
    std::string line;
    for (Group& group : groups_) {
        std::vector<std::string> texts(group.titles.size());
        std::size_t expected = 0;
        for (auto& [title, text] : FieldCells(*group.field, record, units_).cells()) {
            const std::size_t place = place_of(group, title, expected);
            texts.resize(group.titles.size());
            texts[place] = std::move(text);
            expected = place + 1;
        }
        for (const std::string& text : texts) { append_field(line, text); }
    }
    return line + "\n";
}

}  // namespace kreisel
