// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/line.hpp"

#include <fmt/format.h>

#include "records/cell/fields.hpp"
#include "records/json/writer.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

// Unescaped quotes do not occur inside a JSON string, so this can only be a member.
constexpr std::string_view sum_key = ",\"sum\":\"";

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

ReferenceNote note_of(const Reference& reference, double t_end) {
    ReferenceNote note;
    // References are computed in quad whatever the cell's precision: their bounds are given as rounded decimals.
    for (const auto& [metric, bound] : reference.error) { note.error[metric] = bound.value; }
    note.horizon = reference.horizon;
    note.past_horizon = t_end > reference.horizon;
    return note;
}

Number counted(long count) { return {static_cast<double>(count), fmt::format("{}", count)}; }

// A cell of constant steps has the counts that it has always had, unless its kind is about costs.
std::vector<std::pair<std::string, Number>> counts_of(const Cell& cell, const Cost& cost) {
    std::vector<std::pair<std::string, Number>> counts = {
        {"evaluations", counted(cost.evaluations)},
        {"projection_iterations", counted(cost.projection_iterations)},
        {"output_evaluations", counted(cost.output_evaluations)}};
    if (cell.tolerance > 0) {
        counts.emplace_back("accepted", counted(cost.accepted));
        counts.emplace_back("rejected", counted(cost.rejected));
    }
    if (cell.tolerance > 0 || cell.repeated) {
        counts.emplace_back("exponentials", counted(cost.exponentials));
        counts.emplace_back("brackets", counted(cost.brackets));
        counts.emplace_back("newton_iterations", counted(cost.newton_iterations));
    }
    return counts;
}

bool sum_holds(const std::string& journal_line) {
    const auto sum_at = journal_line.rfind(sum_key);
    if (sum_at == std::string::npos) { return false; }
    const std::string sum = hash_text(std::string_view(journal_line).substr(0, sum_at));
    return std::string_view(journal_line).substr(sum_at) == fmt::format("{}{}\"}}", sum_key, sum);
}

}  // namespace

CellRecord record_of(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                     const std::string& trajectory_sum) {
    const Cost& cost = outcome.cost;
    CellRecord record{planned.identity, {}, {cost.cpu_s, cost.step_s, cost.memory, {}}};
    if (planned.cell.repeated) { record.times.run_s = cost.run_s; }
    CellOutcome& result = record.outcome;
    result.status = outcome.status;
    result.detail = outcome.detail;
    result.steps_done = outcome.steps_done;
    result.t_reached = outcome.t_reached;
    result.bodies = planned.cell.timed ? outcome.bodies : 0;
    result.final = outcome.final;
    result.constraints = outcome.constraints;
    result.metrics = outcome.metrics;
    result.unmeasured = outcome.unmeasured;
    result.lost = outcome.lost;
    if (reference != nullptr) { result.reference = note_of(*reference, planned.cell.t_end); }
    result.trajectory = trajectory_sum.empty() ? "" : trajectory_file(planned.hash);
    result.trajectory_sum = trajectory_sum;
    result.counts = counts_of(planned.cell, cost);
    return record;
}

std::string result_text(const CellRecord& record) { return line_of(record, LineKind::result).text(); }

void add_identity(const CellIdentity& identity, ObjectWriter& object) {
    add_fields({identity, {}, {}}, FieldPart::identity, LineKind::result, object);
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
    const std::string text = line_of(record, LineKind::journal).member("build", json_text(build)).open_text();
    return fmt::format("{}{}{}\"}}", text, sum_key, hash_text(text));
}

std::optional<CellRecord> read_journal_line(const std::string& line, const std::string& build) {
    if (!sum_holds(line)) { return std::nullopt; }
    const JsonValue value = parse_exactly(line);  // the check sum is right, so the line is intact
    if (value.at("build").string() != build) { return std::nullopt; }
    return read_record(value);
}

std::optional<std::string> journalled_cell(const std::string& line) {
    if (!sum_holds(line)) { return std::nullopt; }
    return parse_exactly(line).at("cell").string();
}

}  // namespace kreisel
