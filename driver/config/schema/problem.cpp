// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/schema/problem.hpp"

#include <nlohmann/json.hpp>

#include "driver/config/parameters.hpp"
#include "records/json/model.hpp"
#include "records/json/model_keys.hpp"
#include "records/json/node.hpp"
#include "records/json/writer.hpp"

namespace kreisel::schema {

namespace {

Schema matrix() { return list_of_three(list_of_three(number())); }

// Moments, or a matrix with positive ones on its diagonal.
Schema inertia() {
    Schema rows = Schema::array();
    for (std::size_t i = 0; i < 3; ++i) {
        Schema row = list_of_three(Schema::array({number(), number(), number()}));
        row["items"][i] = positive();
        rows.push_back(row);
    }
    return {{"anyOf", {list_of_three(positive()), list_of_three(rows)}}};
}

// What joints and forces call a body by.
Schema body_name() {
    return {{"type", "string"}, {"maxLength", 64}, {"pattern", "^[A-Za-z0-9_-]+$"}, {"not", {{"const", "ground"}}}};
}

Schema motion() {
    const Schema sinusoid =
        object({{"amplitude", number()}, {"frequency", number()}, {"phase", number()}}, {"amplitude", "frequency"});
    Schema schema = object({{"polynomial", list(number(), 1)}, {"sinusoids", list(sinusoid, 1)}}, {});
    schema["minProperties"] = 1;
    return schema;
}

Schema value(ValueKind kind) {
    switch (kind) {
        case ValueKind::name:
        case ValueKind::label:
            return text(64);
        case ValueKind::names:
            return list_of(2, text(64));
        case ValueKind::number:
            return number();
        case ValueKind::whole:
            return integer(-largest_whole, largest_whole);
        case ValueKind::positive:
            return positive();
        case ValueKind::not_negative:
            return not_negative();
        case ValueKind::numbers:
            return list(number(), 1);
        case ValueKind::not_negatives:
            return list_of_three(not_negative());
        case ValueKind::vector:
            return list_of_three(number());
        case ValueKind::vectors:
            return list_of(2, list_of_three(number()));
        case ValueKind::matrix:
            return matrix();
        case ValueKind::quaternion:
            return list_of(4, number());
        case ValueKind::inertia:
            return inertia();
        case ValueKind::frame:
            return choice({"space", "body"});
        case ValueKind::teeth:
            return list_of(2, integer(-largest_whole, largest_whole));
        case ValueKind::motion:
            return motion();
    }
    return {};
}

Schema direction() {
    Schema axis = list_of_three(number());
    axis["not"] = {{"const", {0, 0, 0}}};
    return axis;
}

// Its description tells what the keys mean: of joints they mean other things.
Schema shape() {
    Schema alternatives = Schema::array();
    for (const ElementType& type : shape_types()) {
        Schema properties = {{"type", {{"const", type.name}}}};
        std::vector<std::string> required = {"type"};
        for (const ElementKey& key : type.keys) {
            properties[key.name] = key.name == "axis"   ? direction()
                                   : key.name == "size" ? list_of_three(positive())
                                                        : positive();
            if (key.required) { required.push_back(key.name); }
        }
        alternatives.push_back(object(properties, required));
    }
    return {{"anyOf", alternatives}, {"description", shape_meaning}};
}

// {"required": ["one"]}
Schema has_all(const std::vector<std::string>& keys) { return {{"required", keys}}; }

Schema element(const ElementType& type, bool must_say_type, bool names_bodies) {
    Schema properties = {{"type", {{"const", type.name}}}};
    std::vector<std::string> required;
    if (must_say_type) { required.emplace_back("type"); }
    for (const ElementKey& key : type.keys) {
        properties[key.name] = names_bodies && key.name == "name" ? body_name() : value(key.kind);
        properties[key.name]["description"] = meaning_of_key(key.name);
        if (key.required) { required.push_back(key.name); }
    }
    if (may_have_shape(type)) { properties[shape_key] = shape(); }
    Schema schema = object(properties, required);
    schema["description"] = type.summary;
    for (const auto& [one, other, needed] : type.alternatives) {
        Schema rule = {{"not", has_all({one, other})}};
        if (needed) { rule = {{"oneOf", {has_all({one}), has_all({other})}}}; }
        schema["allOf"].push_back(rule);
    }
    return schema;
}

Schema element_list(ParameterKind kind, std::size_t least) {
    const ElementList& elements = elements_of(kind);
    Schema alternatives = Schema::array();
    for (const ElementType& type : elements.types) {
        alternatives.push_back(element(type, type.name != elements.standard, kind == ParameterKind::bodies));
    }
    return list({{"anyOf", alternatives}}, least);
}

Schema parameter(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::scalar:
            return number();
        case ParameterKind::positive:
            return positive();
        case ParameterKind::count:
            return integer(1, largest_parameter_count);
        case ParameterKind::vector:
            return list_of_three(number());
        case ParameterKind::inertia:
            return inertia();
        case ParameterKind::rotation:
            return matrix();
        case ParameterKind::bodies:
            return element_list(kind, 1);
        case ParameterKind::joints:
        case ParameterKind::forces:
            return element_list(kind, 0);
        case ParameterKind::flag:
            return {{"type", "boolean"}};
    }
    return {};
}

// One value, or values that cells take one after the other.
Schema value_or_axis(ParameterKind kind) {
    const Schema one = parameter(kind);
    Schema axis = object({{"axis", list(one)}, {"zip", text(64)}}, {"axis"});
    axis["anyOf"] = {has_all({"zip"}), {{"properties", {{"axis", {{"uniqueItems", true}}}}}}};
    Schema choices = {one, axis};
    const bool is_number =
        kind == ParameterKind::scalar || kind == ParameterKind::positive || kind == ParameterKind::count;
    if (is_number) { choices.push_back(set(one)); }
    return {{"anyOf", choices}};
}

// Parameters in the config, or from a file (driver/config/composition/mechanism_files.hpp).
Schema written_or_from_file(Schema parameters, const std::vector<std::string>& required) {
    const Schema coordinates = {{"type", "object"}, {"additionalProperties", number()}};
    parameters["file"] = text(4096);
    parameters["file"]["description"] =
        "path of a JSON file with these keys, or of a robot (URDF), relative to the config";
    parameters["positions"] = parameters["rates"] = coordinates;
    parameters["root"] = choice({"ground", "free"});
    Schema schema = object(parameters, {});
    for (const char* key : {"positions", "rates", "root"}) { schema["dependencies"][key] = {"file"}; }
    if (!required.empty()) { schema["anyOf"] = {has_all(required), has_all({"file"})}; }
    return schema;
}

}  // namespace

Schema problem_object(const ProblemDescription& problem) {
    Schema parameters = Schema::object();
    for (const ParameterDescription& description : problem.parameters) {
        parameters[description.name] = value_or_axis(description.kind);
        parameters[description.name]["description"] = description.summary + " [" + description.unit + "]";
        if (!description.required) {
            parameters[description.name]["default"] = Schema::parse(json_value(description.standard));
        }
    }
    Schema label = text(200);
    label["not"] = {{"pattern", "^[=+@-]"}};
    const std::vector<std::string> required = required_parameters(problem);
    return object({{"name", {{"const", problem.name}}},
                   {"label", label},
                   {"parameters", written_or_from_file(parameters, required)},
                   {"exact", {{"type", "boolean"}}}},
                  required.empty() ? std::vector<std::string>{"name"} : std::vector<std::string>{"name", "parameters"});
}

}  // namespace kreisel::schema
