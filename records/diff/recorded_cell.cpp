// SPDX-License-Identifier: BSD-3-Clause
#include "records/diff/recorded_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace kreisel {

namespace {

using nlohmann::json;

RecordedNumber recorded_number(const json& value) {
    if (value.is_string()) { return quad_number(value.get_ref<const std::string&>()); }
    if (!value.is_number()) { throw std::invalid_argument("expected a number, got " + value.dump()); }
    return {value.get<double>()};
}

/// Names the numbers of one part of a line.
class QuantityReader {
  public:
    explicit QuantityReader(RecordedQuantities& quantities) : quantities_(quantities) {}

    /// A number, or lists of numbers, which are counted from 1: "x.3", "R.2.3".
    void add(const std::string& name, const std::string& family, const json& value) {
        if (!value.is_array()) {
            if (!quantities_.insert({name, {family, recorded_number(value)}}).second) {
                throw std::invalid_argument(name + " stands twice");
            }
            return;
        }
        for (std::size_t i = 0; i < value.size(); ++i) { add(fmt::format("{}.{}", name, i + 1), family, value[i]); }
    }
    /// The members of `object` among `names`, each its own family.
    void add_members(const json& object, const std::string& prefix, const std::vector<std::string>& names) {
        for (const std::string& name : names) {
            if (object.contains(name)) { add(prefix + name, prefix + name, object[name]); }
        }
    }
    void add_all_members(const json& object, const std::string& prefix, const std::vector<std::string>& but = {}) {
        for (const auto& [name, value] : object.items()) {
            if (std::find(but.begin(), but.end(), name) == but.end()) { add(prefix + name, prefix + name, value); }
        }
    }

  private:
    RecordedQuantities& quantities_;
};

/// The part of `line` under `key`; an empty object where it is absent.
const json& part(const json& line, const char* key) {
    static const json nothing = json::object();
    const auto found = line.find(key);
    return found == line.end() ? nothing : *found;
}

/// "lambda.pin.2 [N]" is the quantity final.lambda.pin.2 of the family "final.multipliers [N]".
void add_multipliers(QuantityReader& reader, const json& state) {
    const json& multipliers = part(state, "multipliers");
    const json& names = part(state, "multiplier_names");
    for (std::size_t i = 0; i < multipliers.size(); ++i) {
        const std::string title = i < names.size() ? names[i].get<std::string>() : fmt::format("lambda.{}", i + 1);
        const auto unit = std::min(title.rfind(" ["), title.size());
        reader.add("final." + title.substr(0, unit), "final.multipliers" + title.substr(unit), multipliers[i]);
    }
}

void add_state(QuantityReader& reader, const json& state) {
    reader.add_members(state, "final.", {"t", "theta", "turns"});
    const json& bodies = part(state, "bodies");
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const std::string name = bodies[i].value("name", fmt::format("body{}", i + 1));
        for (const char* key : {"x", "R", "v", "omega"}) {
            const std::string family = fmt::format("final.{}", key);
            if (bodies[i].contains(key)) { reader.add(fmt::format("final.{}.{}", name, key), family, bodies[i][key]); }
        }
    }
    add_multipliers(reader, state);
    for (const json& reaction : part(state, "reactions")) {
        const std::string name = "final.reaction." + reaction.at("joint").get<std::string>();
        reader.add(name + ".force", "final.reaction.force", reaction.at("force"));
        reader.add(name + ".torque", "final.reaction.torque", reaction.at("torque"));
    }
}

void add_others(QuantityReader& reader, const json& line) {
    reader.add_members(line, "", {"bodies", "steps_done", "t_reached"});
    reader.add_members(part(line, "constraints"), "constraints.",
                       {"rows", "rank", "condition", "least_norm_multipliers"});
    reader.add_members(part(line, "reference"), "reference.", {"horizon"});
    reader.add_all_members(part(part(line, "reference"), "error"), "reference.");
    reader.add_all_members(part(line, "cost"), "cost.", {"cpu_s", "step_s", "memory"});  // these differ from run to run
}

/// Every number as a double: 1 and 1.0 are the same.
json with_doubles(json value) {
    if (value.is_number()) { return value.get<double>(); }
    if (value.is_structured()) {
        for (json& entry : value) { entry = with_doubles(std::move(entry)); }
    }
    return value;
}

std::string identity_text(const json& value) {
    if (value.is_string()) { return value.get<std::string>(); }
    return value.is_number() ? fmt::format("{}", value.get<double>()) : with_doubles(value).dump();
}

std::map<std::string, std::string> identity_of_line(const json& line) {
    std::map<std::string, std::string> identity;
    for (const char* key :
         {"problem", "formulation", "method", "projection", "precision", "steps", "t_end", "tolerance"}) {
        if (line.contains(key)) { identity[key] = identity_text(line[key]); }
    }
    for (const char* key : {"parameters", "options", "projection_options"}) {
        for (const auto& [name, value] : part(line, key).items()) {
            identity[fmt::format("{}.{}", key, name)] = identity_text(value);
        }
    }
    return identity;
}

}  // namespace

RecordedCell read_recorded_cell(const std::string& text) {
    const json line = json::parse(text);
    RecordedCell cell;
    cell.cell = line.at("cell");
    cell.identity = identity_of_line(line);
    cell.label = line.value("label", line.at("problem").get<std::string>());
    cell.status = line.at("status");
    cell.t_end = line.contains("t_end") ? recorded_number(line["t_end"]).value : 0;
    QuantityReader state(cell.final_state), metrics(cell.metrics), others(cell.others);
    add_state(state, part(line, "final"));
    metrics.add_all_members(part(line, "metrics"), "");
    add_others(others, line);
    cell.trajectory_sum = line.value("trajectory_sum", "");
    return cell;
}

}  // namespace kreisel
