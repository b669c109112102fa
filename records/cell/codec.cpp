// SPDX-License-Identifier: BSD-3-Clause
#include "records/cell/codec.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "records/json/lists.hpp"
#include "records/json/written/written.hpp"

namespace kreisel {

namespace {

/// The times of a cost by name.
template <class Times>
auto* time_named(std::string_view name, Times& times) {
    return name == "step_s"   ? &times.step_s
           : name == "memory" ? &times.memory
           : name == "run_s"  ? &times.run_s
                              : nullptr;
}

template <class Value>
void decode_member(const JsonValue& object, const char* name, Value& value) {
    if (const JsonValue* member = object.find(name)) { decode(*member, value); }
}

template <class Value>
void decode_list(const JsonValue& object, const char* name, std::vector<Value>& values) {
    const JsonValue* list = object.find(name);
    if (list == nullptr) { return; }
    for (const JsonValue& element : list->elements) { decode(element, values.emplace_back()); }
}

template <std::size_t n>
void decode_member(const JsonValue& object, const char* name, std::array<Number, n>& values) {
    const JsonValue* list = object.find(name);
    if (list == nullptr) { return; }
    std::vector<const JsonValue*> numbers;  // of a matrix row by row
    for (const JsonValue& element : list->elements) {
        if (!element.is_list()) { numbers.push_back(&element); }
        for (const JsonValue& number : element.elements) { numbers.push_back(&number); }
    }
    if (numbers.size() != n) { throw std::invalid_argument(fmt::format("{}: expected {} numbers", name, n)); }
    for (std::size_t i = 0; i < n; ++i) { decode(*numbers[i], values[i]); }
}

ReportedBody decoded_body(const JsonValue& json, std::size_t place) {
    ReportedBody body{fmt::format("body{}", place), {}, {}, {}, {}};
    decode_member(json, "name", body.name);
    decode_member(json, "x", body.x);
    decode_member(json, "R", body.R);
    decode_member(json, "v", body.v);
    decode_member(json, "omega", body.omega);
    return body;
}

ReportedReaction decoded_reaction(const JsonValue& json) {
    ReportedReaction reaction{json.at("joint").string(), {}, {}};
    decode_member(json, "force", reaction.force);
    decode_member(json, "torque", reaction.torque);
    const auto decode_drive = [&](const char* name, std::optional<Number>& number) {
        if (json.find(name) != nullptr) { decode_member(json, name, number.emplace()); }
    };
    decode_drive("driving_force", reaction.driving_force);
    decode_drive("driving_torque", reaction.driving_torque);
    const JsonValue* unique = json.find("unique");
    reaction.unique = unique == nullptr || unique->flag();
    return reaction;
}

}  // namespace

std::string encoded(const std::string& text) { return json_text(text); }
std::string encoded(long count) { return std::to_string(count); }
std::string encoded(int count) { return std::to_string(count); }
std::string encoded(double number) { return json_number(number); }
std::string encoded(const JsonValue& value) { return json_value(value); }
std::string encoded(const OptionValues& options) { return json_value(options); }

std::string encoded(const std::optional<Order>& order) {
    return ObjectWriter()
        .member("configuration", encoded(order->configuration))
        .member("velocity", encoded(order->velocity))
        .member("multipliers", encoded(order->multipliers))
        .text();
}

std::string encoded(const std::map<std::string, std::string>& texts) {
    ObjectWriter object;
    for (const auto& [name, text] : texts) { object.member(name, json_text(text)); }
    return object.text();
}

std::string encoded(const std::optional<LostIntegral>& lost) {
    return ObjectWriter().member("integral", json_text(lost->name)).member("share", json_number(lost->share)).text();
}

std::string encoded(const std::optional<ReferenceNote>& reference) {
    ObjectWriter error, object;
    for (const auto& [name, bound] : reference->error) { error.member(name, json_number(bound)); }
    object.member("error", error.text()).member("horizon", json_number(reference->horizon));
    if (reference->past_horizon) { object.member("past_horizon", "true"); }
    return object.text();
}

std::string encoded(const std::optional<ReportedState>& state, bool quad) { return json_value(*state, quad); }

std::string encoded(const ConstraintSummary& constraints, bool quad) {
    ObjectWriter object;
    object.member("rows", encoded(constraints.rows)).member("rank", encoded(constraints.rank));
    if (constraints.condition) { object.member("condition", json_number(*constraints.condition)); }
    if (constraints.has_redundant_rows()) { object.member("redundant", json_value(constraints.redundant)); }
    if (!constraints.least_norm.empty()) {
        const auto write = [quad](const Number& number) { return json_value(number, quad); };
        object.member("least_norm_multipliers", json_list(constraints.least_norm, write));
    }
    return object.text();
}

std::string encoded(const std::vector<std::pair<std::string, Number>>& metrics, bool quad) {
    ObjectWriter object;
    for (const auto& [name, number] : metrics) { object.member(name, json_value(number, quad)); }
    return object.text();
}

void decode(const JsonValue& json, std::string& text) { text = json.string(); }
void decode(const JsonValue& json, long& count) { count = json.count(); }
void decode(const JsonValue& json, int& count) { count = static_cast<int>(json.count()); }
void decode(const JsonValue& json, double& number) { number = json.number(); }
void decode(const JsonValue& json, JsonValue& value) { value = json; }
void decode(const JsonValue& json, Number& number) { number = {json.number(), json.text}; }

void decode(const JsonValue& json, OptionValues& options) {
    for (const JsonMember& member : json.members) {
        const JsonValue& value = member.value;
        OptionValue& option = options[member.name];
        if (value.kind == JsonValue::Kind::number) {
            const bool whole = value.text.find_first_not_of("-0123456789") == std::string::npos;
            option = whole ? OptionValue(value.count()) : OptionValue(value.number());
        } else if (value.kind == JsonValue::Kind::flag) {
            option = value.flag();
        } else {
            option = value.string();
        }
    }
}

void decode(const JsonValue& json, std::optional<Order>& order) {
    const auto level = [&](const char* name) { return static_cast<int>(json.at(name).count()); };
    order = Order(level("configuration"), level("velocity"), level("multipliers"));
}

void decode(const JsonValue& json, std::map<std::string, std::string>& texts) {
    for (const JsonMember& member : json.members) { texts[member.name] = member.value.string(); }
}

void decode(const JsonValue& json, std::optional<LostIntegral>& lost) {
    lost = LostIntegral{json.at("integral").string(), json.at("share").number()};
}

void decode(const JsonValue& json, std::optional<ReferenceNote>& reference) {
    reference.emplace();
    reference->horizon = json.at("horizon").number();
    if (const JsonValue* error = json.find("error")) {
        for (const JsonMember& bound : error->members) { reference->error[bound.name] = bound.value.number(); }
    }
    const JsonValue* past = json.find("past_horizon");
    reference->past_horizon = past != nullptr && past->flag();
}

void decode(const JsonValue& json, ReportedState& state) {
    decode_member(json, "t", state.t);
    if (const JsonValue* bodies = json.find("bodies")) {
        for (const JsonValue& body : bodies->elements) {
            state.bodies.push_back(decoded_body(body, state.bodies.size() + 1));
        }
    }
    decode_list(json, "multipliers", state.multipliers);
    decode_list(json, "multiplier_names", state.multiplier_names);
    decode_list(json, "theta", state.theta);
    decode_list(json, "turns", state.turns);
    const JsonValue* reactions = json.find("reactions");
    if (reactions == nullptr) { return; }
    for (const JsonValue& reaction : reactions->elements) { state.reactions.push_back(decoded_reaction(reaction)); }
}

void decode(const JsonValue& json, std::optional<ReportedState>& state) { decode(json, state.emplace()); }

void decode(const JsonValue& json, ConstraintSummary& constraints) {
    decode_member(json, "rows", constraints.rows);
    decode_member(json, "rank", constraints.rank);
    decode_list(json, "redundant", constraints.redundant);
    decode_list(json, "least_norm_multipliers", constraints.least_norm);
    if (const JsonValue* condition = json.find("condition")) { constraints.condition = condition->number(); }
}

void decode(const JsonValue& json, std::vector<std::pair<std::string, Number>>& metrics) {
    for (const JsonMember& metric : json.members) {
        Number number;
        decode(metric.value, number);
        metrics.emplace_back(metric.name, number);
    }
}

bool is_default(const std::string& text) { return text.empty(); }
bool is_default(long count) { return count == 0; }
bool is_default(int count) { return count == 0; }
bool is_default(double number) { return number == 0; }
bool is_default(const JsonValue& value) { return value.is_null(); }
bool is_default(const OptionValues& options) { return options.empty(); }
bool is_default(const std::map<std::string, std::string>& texts) { return texts.empty(); }
bool is_default(const ConstraintSummary& constraints) { return constraints.rows == 0; }

void add_times(const CellTimes& times, ObjectWriter& object) {
    object.member("cpu_s", json_number(times.cpu_s));
    if (times.step_s) { object.member("step_s", json_number(*times.step_s)); }
    if (times.memory) { object.member("memory", json_number(*times.memory)); }
    if (times.run_s) { object.member("run_s", json_number(*times.run_s)); }
}

std::string without_times(std::string_view cost) {
    CellTimes times;
    ObjectWriter object;
    for (const WrittenMember& member : members_of(cost)) {
        const bool is_time = member.name == "cpu_s" || time_named(member.name, times) != nullptr;
        if (!is_time) { object.member(member.name, member.json); }
    }
    return object.text();
}

bool read_time(const JsonMember& member, CellTimes& times) {
    if (member.name == "cpu_s") { return times.cpu_s = member.value.number(), true; }
    auto* time = time_named(member.name, times);
    if (time != nullptr) { *time = member.value.number(); }
    return time != nullptr;
}

}  // namespace kreisel
