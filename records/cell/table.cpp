// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/table.hpp"

#include <algorithm>

#include "records/cell/states/state_names.hpp"
#include "records/cell/states/written_state.hpp"
#include "records/json/written/written.hpp"
#include "support/csv.hpp"

namespace kreisel {

namespace {

/// Puts the value of one field into its columns. Titles are made in one place, since there are many and most are known.
class FieldCells {
  public:
    FieldCells(const RecordField& field, const Units* units, ColumnGroup& columns)
        : field_(field), units_(units), columns_(columns), title_(field.column == "*" ? "" : field.column) {}

    void put(std::string_view json) {
        if (field_.column == "final.") {
            put_final_state(json);
        } else if (json.starts_with('{')) {
            for (const WrittenMember& member : members_of(json)) {
                with_title(member.name, [&] { put_numbers(member.json, unit_of(std::string(member.name))); });
            }
        } else {
            put_text("", text_of(json, unescaped_));
        }
    }

  private:
    void put_final_state(std::string_view json) {
        const WrittenState final = written_state(json);
        if (final.bodies.size() > most_bodies_in_table) { return; }
        name_state(final, final.turns, [&](const StateEntryName& entry, std::string_view number) {
            with_title(entry.name, [&] { put_text(entry.unit, number); });
        });
    }

    /// A scalar, or the numbers of a vector or matrix; lists of bodies, joints and forces are in JSON lines only.
    void put_numbers(std::string_view json, std::string_view unit) {
        for_each_scalar(json, title_, [&](std::string_view scalar) {
            if (!scalar.starts_with('{') && scalar != "null") { put_text(unit, text_of(scalar, unescaped_)); }
        });
    }

    std::string unit_of(const std::string& name) const {
        if (units_ == nullptr) { return ""; }
        if (field_.column == "*") { return metric_unit(name, *units_); }
        const auto unit = units_->find(name);
        return unit == units_->end() ? "" : unit->second;
    }

    template <class Put>
    void with_title(std::string_view more, const Put& put) {
        const std::size_t size = title_.size();
        title_ += more;
        put();
        title_.resize(size);
    }

    void put_text(std::string_view unit, std::string_view text) {
        if (unit.empty()) { return columns_.put(title_, text); }
        const std::size_t size = title_.size();
        title_.append(" [").append(unit).append("]");
        columns_.put(title_, text);
        title_.resize(size);
    }

    const RecordField& field_;
    const Units* units_;  // of its columns, where it has any
    ColumnGroup& columns_;
    std::string title_, unescaped_;
};

/// The places of the fields that have columns, in the order of these.
std::vector<std::size_t> column_fields() {
    std::vector<std::size_t> places, last;
    for (std::size_t place = 0; place < record_fields().size(); ++place) {
        const std::string& column = record_fields()[place].column;
        if (!column.empty()) { (column == "final." ? last : places).push_back(place); }
    }
    places.insert(places.end(), last.begin(), last.end());
    return places;
}

std::size_t field_named(const std::string& name) {
    const auto& fields = record_fields();
    return static_cast<std::size_t>(
        std::find_if(fields.begin(), fields.end(), [&](const RecordField& field) { return field.name == name; }) -
        fields.begin());
}

void append_field(std::string& line, std::string_view text) {
    if (!line.empty()) { line += ','; }
    append_csv_field(line, text);
}

/// Null where the columns of a field have none.
const Units* units_of(const RecordField& field, const std::string& problem, const TableUnits& units) {
    if (field.column == "*") { return &units.metrics; }
    const auto found = field.column == "parameter." ? units.parameters.find(problem) : units.parameters.end();
    return found == units.parameters.end() ? nullptr : &found->second;
}

}  // namespace

ResultsTable::ResultsTable(TableUnits units) : units_(std::move(units)) {
    for (const std::size_t field : column_fields()) { groups_.push_back({field}); }
}

std::size_t ResultsTable::columns() const {
    std::size_t count = 0;
    for (const Group& group : groups_) { count += group.columns.titles().size(); }
    return count;
}

std::string ResultsTable::header() const {
    std::string line;
    for (const Group& group : groups_) {
        for (const std::string& title : group.columns.titles()) { append_field(line, title); }
    }
    return line + "\n";
}

std::string ResultsTable::row(const FieldValues& values) {
    static const std::size_t problem_field = field_named("problem");
    const std::string problem = text_of(values.at(problem_field));
    std::string row;
    for (Group& group : groups_) {
        const std::string_view json = values.at(group.field);
        if (json != group.json || problem != problem_) { put(json, problem, group); }
        row += group.texts;
    }
    problem_ = problem;
    if (!row.empty()) { row.pop_back(); }
    row += '\n';
    return row;
}

void ResultsTable::put(std::string_view json, const std::string& problem, Group& group) const {
    const RecordField& field = record_fields()[group.field];
    group.columns.begin_row();
    if (!json.empty()) { FieldCells(field, units_of(field, problem, units_), group.columns).put(json); }
    group.texts.clear();
    for (const std::string& text : group.columns.texts()) {
        append_csv_field(group.texts, text);
        group.texts += ',';
    }
    group.json = json;
}

}  // namespace kreisel
