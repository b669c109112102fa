// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/line.hpp"

#include <stdexcept>

#include "records/cell/fields.hpp"
#include "records/json/writer.hpp"
#include "records/json/written/written.hpp"
#include "records/sums/summed_text.hpp"

namespace kreisel {

namespace {

void add_fields(const CellRecord& record, FieldPart part, LineKind kind, ObjectWriter& object) {
    for (const RecordField& field : record_fields()) {
        const std::string text = field.part == part ? field.write(record, kind) : "";
        if (!text.empty()) { object.member(field.name, text); }
    }
}

ObjectWriter line_of(const CellRecord& record, LineKind kind) {
    ObjectWriter object;
    add_fields(record, FieldPart::identity, kind, object);
    add_fields(record, FieldPart::outcome, kind, object);
    return object;
}

/// Writes the members of a line, and keeps in mind where the value of each field is.
class PlacedMembers {
  public:
    void add(const RecordField& field, std::string_view json) {
        if (!json.empty()) { object_.member(field.name, json); }
        places_.emplace_back(open_text().size() - json.size(), json.size());
    }
    const std::string& open_text() const { return object_.open_text(); }
    /// In a text that begins with the members.
    FieldValues values_in(std::string_view text) const {
        FieldValues values;
        values.reserve(places_.size());
        for (const auto& [begin, size] : places_) { values.push_back(text.substr(begin, size)); }
        return values;
    }

  private:
    ObjectWriter object_;
    std::vector<std::pair<std::size_t, std::size_t>> places_;
};

ReferenceNote note_of(const Reference& reference, double t_end) {
    ReferenceNote note;
    // References are computed in quad whatever the cell's precision: their bounds are given as rounded decimals.
    for (const auto& [metric, bound] : reference.error) { note.error[metric] = bound.value; }
    note.horizon = reference.horizon;
    note.past_horizon = t_end > reference.horizon;
    return note;
}

Number counted(long count) { return {static_cast<double>(count), std::to_string(count)}; }

// A cell of constant steps has the counts that it has always had, unless its kind is about costs.
std::vector<std::pair<std::string, Number>> counts_of(const PlannedCell& planned, const Cost& cost) {
    std::vector<std::pair<std::string, Number>> counts = {
        {"evaluations", counted(cost.evaluations)},
        {"projection_iterations", counted(cost.projection_iterations)},
        {"output_evaluations", counted(cost.output_evaluations)}};
    if (planned.tolerance > 0) {
        counts.emplace_back("accepted", counted(cost.accepted));
        counts.emplace_back("rejected", counted(cost.rejected));
    }
    if (planned.tolerance > 0 || planned.run->cell.repeated) {
        counts.emplace_back("exponentials", counted(cost.exponentials));
        counts.emplace_back("brackets", counted(cost.brackets));
        counts.emplace_back("newton_iterations", counted(cost.newton_iterations));
    }
    return counts;
}

}  // namespace

CellRecord record_of(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                     const std::string& trajectory_sum) {
    const Cost& cost = outcome.cost;
    const Cell& common = planned.run->cell;
    CellRecord record{planned.identity(), {}, {cost.cpu_s, cost.step_s, cost.memory, {}}};
    if (common.repeated) { record.times.run_s = cost.run_s; }
    CellOutcome& result = record.outcome;
    result.status = outcome.status;
    result.detail = outcome.detail;
    result.steps_done = outcome.steps_done;
    result.t_reached = outcome.t_reached;
    result.bodies = common.timed ? outcome.bodies : 0;
    result.final = outcome.final;
    result.constraints = outcome.constraints;
    result.metrics = outcome.metrics;
    result.unmeasured = outcome.unmeasured;
    result.lost = outcome.lost;
    if (reference != nullptr) { result.reference = note_of(*reference, common.t_end); }
    result.trajectory = trajectory_sum.empty() ? "" : trajectory_file(planned.hash());
    result.trajectory_sum = trajectory_sum;
    result.counts = counts_of(planned, cost);
    return record;
}

std::string result_text(const CellRecord& record) { return line_of(record, LineKind::result).text(); }

ResultLine::ResultLine(CellIdentity identity, std::string_view journal_line) {
    const CellRecord told{std::move(identity), {}, {}};
    PlacedMembers members;
    for (const RecordField& field : record_fields()) {
        if (field.part == FieldPart::identity) { members.add(field, field.write(told, LineKind::result)); }
    }
    WrittenObject journalled(members_behind(members.open_text(), journal_line));
    for (const RecordField& field : record_fields()) {
        if (field.part == FieldPart::identity) { continue; }
        const std::string_view json = journalled.value_of(field.name);
        const bool changes = field.of_result != nullptr && !json.empty();
        changes ? members.add(field, field.of_result(json)) : members.add(field, json);
    }
    text_ = with_sum(members.open_text());
    values_ = members.values_in(text_);
}

FieldValues field_values(std::string_view line) {
    WrittenObject members(line);
    FieldValues values;
    for (const RecordField& field : record_fields()) { values.push_back(members.value_of(field.name)); }
    return values;
}

void add_identity(CellIdentity identity, ObjectWriter& object) {
    add_fields({std::move(identity), {}, {}}, FieldPart::identity, LineKind::result, object);
}

CellRecord read_record(const JsonValue& line) {
    CellRecord record;
    for (const RecordField& field : record_fields()) {
        if (const JsonValue* value = line.find(field.name)) { field.read(*value, record); }
    }
    for (const char* name : {"cell", "problem", "status"}) { line.at(name); }
    CellIdentity& identity = record.identity;
    if (identity.label.empty()) { identity.label = identity.problem; }
    if (identity.series.empty()) { identity.series = identity.label; }
    return record;
}

CellRecord read_record(const std::string& line) { return read_record(parse_exactly(line)); }

std::string journal_line(const CellRecord& record, const std::string& build) {
    return with_sum(line_of(record, LineKind::journal).member("build", json_text(build)).open_text());
}

bool is_line_of(std::string_view line, const std::string& hash) {
    return line.starts_with(ObjectWriter().member(record_fields().front().name, json_text(hash)).open_text());
}

std::optional<JournalledCell> read_journal_line(const std::string& line) {
    if (sum_state(line) != SumState::holds) { return std::nullopt; }
    try {
        const JsonValue value = parse_exactly(line);
        JournalledCell cell{read_record(value), value.at("build").string()};
        return is_cell_name(cell.record.identity.cell) ? std::optional(std::move(cell)) : std::nullopt;
    } catch (const std::invalid_argument&) { return std::nullopt; }  // a line with a sum need not be of a journal
}

std::optional<CellRecord> read_journal_line(const std::string& line, const std::string& build) {
    auto cell = read_journal_line(line);
    return cell && cell->build == build ? std::optional(std::move(cell->record)) : std::nullopt;
}

std::optional<std::string> journalled_cell(const std::string& line) {
    const auto cell = read_journal_line(line);
    return cell ? std::optional(cell->record.identity.cell) : std::nullopt;
}

}  // namespace kreisel
