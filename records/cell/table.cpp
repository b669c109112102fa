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

/// The columns of a group of fields, filled row by row.
class TableColumns {
  public:
    void add(std::size_t row, const RowCells& cells) {
        for (const auto& [title, text] : cells) {
            const auto [place, fresh] = places_.insert({title, titles_.size()});
            if (fresh) { titles_.push_back(title), texts_.emplace_back(); }
            texts_[place->second].resize(row);
            texts_[place->second].push_back(text);
        }
    }
    const std::vector<std::string>& titles() const { return titles_; }
    std::string text(std::size_t column, std::size_t row) const {
        return row < texts_[column].size() ? texts_[column][row] : "";
    }

  private:
    std::map<std::string, std::size_t> places_;
    std::vector<std::string> titles_;
    std::vector<std::vector<std::string>> texts_;
};

void append_field(std::string& line, const std::string& text) { line += (line.empty() ? "" : ",") + csv_field(text); }

}  // namespace

std::string results_table(const std::vector<CellRecord>& records, const TableUnits& units) {
    std::vector<TableColumns> groups;
    for (const RecordField* field : column_fields()) {
        TableColumns& columns = groups.emplace_back();
        for (std::size_t row = 0; row < records.size(); ++row) {
            columns.add(row, FieldCells(*field, records[row], units).cells());
        }
    }
    std::string header, table;
    for (const TableColumns& columns : groups) {
        for (const std::string& title : columns.titles()) { append_field(header, title); }
    }
    for (std::size_t row = 0; row < records.size(); ++row) {
        std::string line;
        for (const TableColumns& columns : groups) {
            for (std::size_t i = 0; i < columns.titles().size(); ++i) { append_field(line, columns.text(i, row)); }
        }
        table += line + "\n";
    }
    return header + "\n" + table;
}

}  // namespace kreisel
