// SPDX-License-Identifier: BSD-3-Clause
#include "records/diff/recorded_cell.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "records/cell/line.hpp"
#include "records/cell/state_entries.hpp"
#include "records/json/writer.hpp"
#include "support/number_text.hpp"

namespace kreisel {

namespace {

/// A part of the numbers of a cell.
class QuantityList {
  public:
    QuantityList(RecordedQuantities& quantities, bool quad) : quantities_(quantities), quad_(quad) {}

    void add(const std::string& name, const std::string& family, const Number& number) {
        add(name, family, quad_ ? quad_number(number.text) : RecordedNumber{number.value, ""});
    }
    void add(const std::string& name, double value) { add(name, name, RecordedNumber{value, ""}); }

  private:
    void add(const std::string& name, const std::string& family, const RecordedNumber& number) {
        if (!quantities_.insert({name, {family, number}}).second) {
            throw std::invalid_argument(name + " stands twice");
        }
    }

    RecordedQuantities& quantities_;
    bool quad_;
};

void add_constraints(QuantityList& list, const ConstraintSummary& constraints) {
    if (constraints.rows == 0) { return; }
    list.add("constraints.rows", constraints.rows);
    list.add("constraints.rank", constraints.rank);
    if (constraints.condition) { list.add("constraints.condition", *constraints.condition); }
    for (std::size_t i = 0; i < constraints.least_norm.size(); ++i) {
        const std::string family = "constraints.least_norm_multipliers";
        list.add(fmt::format("{}.{}", family, i + 1), family, constraints.least_norm[i]);
    }
}

void add_others(QuantityList& list, const CellOutcome& outcome) {
    if (outcome.bodies > 0) { list.add("bodies", outcome.bodies); }
    if (outcome.failed()) {
        list.add("steps_done", static_cast<double>(outcome.steps_done));
        list.add("t_reached", outcome.t_reached);
    }
    add_constraints(list, outcome.constraints);
    if (outcome.reference) {
        list.add("reference.horizon", outcome.reference->horizon);
        for (const auto& [metric, bound] : outcome.reference->error) { list.add("reference." + metric, bound); }
    }
    for (const auto& [name, count] : outcome.counts) { list.add("cost." + name, count.value); }
}

std::string canonical(const JsonValue& value) {
    if (value.is_scalar() && value.kind == JsonValue::Kind::number) { return exact_text(value.number()); }
    return value.is_text() ? value.text : canonical_json(value);
}

void add_options(std::map<std::string, std::string>& identity, const std::string& prefix, const OptionValues& options) {
    for (const auto& [name, value] : options) { identity[prefix + name] = canonical(parse_exactly(json_value(value))); }
}

std::map<std::string, std::string> identity_of_record(const CellIdentity& cell) {
    std::map<std::string, std::string> identity = {{"problem", cell.problem},
                                                   {"formulation", cell.formulation},
                                                   {"method", cell.method},
                                                   {"projection", cell.projection},
                                                   {"precision", cell.precision}};
    std::erase_if(identity, [](const auto& one) { return one.second.empty(); });  // not told
    if (cell.steps > 0) { identity["steps"] = fmt::format("{}", cell.steps); }
    if (cell.tolerance > 0) {
        identity["tolerance"] = exact_text(cell.tolerance);
        identity["controller"] = cell.controller;
    }
    if (cell.t_begin != 0) { identity["t_begin"] = exact_text(cell.t_begin); }
    if (cell.t_end != 0) { identity["t_end"] = exact_text(cell.t_end); }
    const JsonValue parameters = parse_exactly(cell.parameters);
    for (const JsonMember& parameter : parameters.members) {
        identity["parameters." + parameter.name] = canonical(parameter.value);
    }
    add_options(identity, "options.", cell.options);
    add_options(identity, "projection_options.", cell.projection_options);
    return identity;
}

}  // namespace

RecordedCell read_recorded_cell(const std::string& line) {
    const CellRecord record = read_record(line);
    const CellOutcome& outcome = record.outcome;
    const bool quad = record.identity.quad();
    RecordedCell cell;
    cell.cell = record.identity.cell;
    cell.identity = identity_of_record(record.identity);
    cell.label = record.identity.label;
    cell.status = outcome.status;
    cell.t_end = record.identity.t_end;
    QuantityList state(cell.final_state, quad), metrics(cell.metrics, quad), others(cell.others, quad);
    if (outcome.final) {
        for (const StateEntry& entry : state_entries(*outcome.final)) {
            state.add("final." + entry.name, "final." + entry.family, entry.number);
        }
    }
    for (const auto& [name, number] : outcome.metrics) { metrics.add(name, name, number); }
    add_others(others, outcome);
    cell.trajectory_sum = outcome.trajectory_sum;
    return cell;
}

}  // namespace kreisel
