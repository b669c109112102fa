// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/fields.hpp"

#include <fmt/format.h>

#include "records/cell/codec.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

/// A member of a part of the record; left out of a line where it has the value of a new record and is `optional`.
enum class Presence { always, optional };

template <class Part, class Value>
RecordField member_field(const char* name, Part CellRecord::*part, Value Part::*member, Presence presence,
                         const char* column) {
    const auto write = [=](const CellRecord& record, LineKind) {
        const Value& value = record.*part.*member;
        return presence == Presence::optional && is_default(value) ? std::string() : encoded(value);
    };
    const auto read = [=](const JsonValue& json, CellRecord& record) { decode(json, record.*part.*member); };
    const FieldPart of = std::is_same_v<Part, CellIdentity> ? FieldPart::identity : FieldPart::outcome;
    return {name, of, write, read, column, std::is_same_v<Value, std::string>};
}

template <class Value>
RecordField identity_field(const char* name, Value CellIdentity::*member, const char* column,
                           Presence presence = Presence::always) {
    return member_field(name, &CellRecord::identity, member, presence, column);
}

/// Not where steps are chosen to a tolerance.
template <class Value>
RecordField of_constant_steps(const char* name, Value CellIdentity::*member, const char* column) {
    RecordField field = identity_field(name, member, column);
    field.write = [write = field.write](const CellRecord& record, LineKind kind) {
        return record.identity.tolerance > 0 ? std::string() : write(record, kind);
    };
    return field;
}

template <class Value>
RecordField outcome_field(const char* name, Value CellOutcome::*member, const char* column,
                          Presence presence = Presence::optional) {
    return member_field(name, &CellRecord::outcome, member, presence, column);
}

RecordField series_field() {
    RecordField field = identity_field("series", &CellIdentity::series, "series");
    field.write = [write = field.write](const CellRecord& record, LineKind kind) {
        return record.identity.series == record.identity.label ? std::string() : write(record, kind);
    };
    return field;
}

RecordField parameters_field() {
    const auto write = [](const CellRecord& record, LineKind) { return record.identity.parameters; };
    const auto read = [](const JsonValue& json, CellRecord& record) { record.identity.parameters = json_value(json); };
    return {"parameters", FieldPart::identity, write, read, "parameter."};
}

/// Only of failed cells.
template <class Value>
RecordField of_failure(const char* name, Value CellOutcome::*member, const char* column) {
    RecordField field = outcome_field(name, member, column, Presence::always);
    field.write = [write = field.write](const CellRecord& record, LineKind kind) {
        return record.outcome.failed() ? write(record, kind) : std::string();
    };
    return field;
}

/// Numbers of the engine, which are in quotes in quad.
template <class Value>
RecordField measured_field(const char* name, Value CellOutcome::*member, const char* column) {
    const auto write = [=](const CellRecord& record, LineKind) {
        const Value& value = record.outcome.*member;
        return is_default(value) ? std::string() : encoded(value, record.identity.quad());
    };
    const auto read = [=](const JsonValue& json, CellRecord& record) { decode(json, record.outcome.*member); };
    return {name, FieldPart::outcome, write, read, column};
}

/// A skipped cell has none; of one that ran they may be none.
RecordField metrics_field() {
    const auto write = [](const CellRecord& record, LineKind) {
        const bool ran = record.outcome.status != "skipped";
        return ran ? encoded(record.outcome.metrics, record.identity.quad()) : std::string();
    };
    const auto read = [](const JsonValue& json, CellRecord& record) { decode(json, record.outcome.metrics); };
    return {"metrics", FieldPart::outcome, write, read, "*"};
}

/// The counts, and in a journal the times.
RecordField cost_field() {
    const auto write = [](const CellRecord& record, LineKind kind) {
        ObjectWriter object;
        for (const auto& [name, count] : record.outcome.counts) { object.member(name, count.text); }
        if (kind == LineKind::journal) { add_times(record.times, object); }
        return object.text();
    };
    const auto read = [](const JsonValue& json, CellRecord& record) {
        for (const JsonMember& member : json.members) {
            if (!read_time(member, record.times)) {
                decode(member.value, record.outcome.counts.emplace_back(member.name, Number()).second);
            }
        }
    };
    return {"cost", FieldPart::outcome, write, read, "cost.", false, without_times};
}

}  // namespace

const std::vector<RecordField>& record_fields() {
    using I = CellIdentity;
    using O = CellOutcome;
    static const std::vector<RecordField> fields = {
        identity_field("cell", &I::cell, "cell"),
        identity_field("problem", &I::problem, "problem"),
        identity_field("label", &I::label, "label"),
        series_field(),
        parameters_field(),
        identity_field("formulation", &I::formulation, "formulation"),
        identity_field("method", &I::method, "method"),
        identity_field("options", &I::options, "option."),
        identity_field("order", &I::order, "", Presence::optional),
        identity_field("projection", &I::projection, "projection"),
        identity_field("projection_options", &I::projection_options, "projection_option."),
        identity_field("precision", &I::precision, "precision"),
        of_constant_steps("steps", &I::steps, "steps"),
        of_constant_steps("h", &I::h, "h [s]"),
        identity_field("tolerance", &I::tolerance, "tolerance [1]", Presence::optional),
        identity_field("controller", &I::controller, "controller", Presence::optional),
        identity_field("t_begin", &I::t_begin, "t_begin [s]", Presence::optional),
        identity_field("t_end", &I::t_end, "t_end [s]"),
        outcome_field("status", &O::status, "status", Presence::always),
        outcome_field("detail", &O::detail, "detail"),
        of_failure("steps_done", &O::steps_done, "steps_done"),
        of_failure("t_reached", &O::t_reached, "t_reached [s]"),
        outcome_field("bodies", &O::bodies, "bodies"),
        measured_field("final", &O::final, "final."),
        measured_field("constraints", &O::constraints, ""),
        metrics_field(),
        outcome_field("unmeasured", &O::unmeasured, ""),
        outcome_field("lost", &O::lost, ""),
        outcome_field("reference", &O::reference, ""),
        outcome_field("trajectory", &O::trajectory, "trajectory"),
        outcome_field("trajectory_sum", &O::trajectory_sum, "trajectory_sum"),
        cost_field(),
    };
    return fields;
}

}  // namespace kreisel
