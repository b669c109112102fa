// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/schema.hpp"

#include <nlohmann/json.hpp>

#include "driver/config/config.hpp"
#include "driver/config/options.hpp"
#include "driver/config/reading/measurements.hpp"
#include "plots/figures/schema.hpp"
#include "records/json/model_keys.hpp"
#include "records/json/node.hpp"
#include "records/kinds/kind.hpp"

namespace kreisel {

namespace {

using Schema = nlohmann::ordered_json;

// C1 and the Unicode separators, which the reader refuses too, are beyond the regular expressions of some checkers.
const char* const no_control_characters = "^[^\\u0000-\\u001F\\u007F]*$";

Schema integer(long least, long most) { return {{"type", "integer"}, {"minimum", least}, {"maximum", most}}; }

Schema number() { return {{"type", "number"}}; }

Schema positive() { return {{"type", "number"}, {"exclusiveMinimum", 0}}; }

Schema list(const Schema& items, std::size_t least = 1) {
    return {{"type", "array"}, {"items", items}, {"minItems", least}};
}

Schema list_of(std::size_t count, const Schema& items) {
    return {{"type", "array"}, {"items", items}, {"minItems", count}, {"maxItems", count}};
}

Schema list_of_three(const Schema& items) { return list_of(3, items); }

Schema one_or_list(const Schema& one) { return {{"anyOf", {one, list(one)}}}; }

Schema choice(const std::vector<std::string>& names) { return {{"type", "string"}, {"enum", names}}; }

Schema text(std::size_t longest) {
    return {{"type", "string"}, {"minLength", 1}, {"maxLength", longest}, {"pattern", no_control_characters}};
}

Schema object(const Schema& properties, const std::vector<std::string>& required) {
    Schema schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
    if (!required.empty()) { schema["required"] = required; }
    return schema;
}

Schema matrix() { return list_of_three(list_of_three(number())); }

Schema inertia() { return {{"anyOf", {list_of_three(number()), matrix()}}}; }

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
            return {{"type", "number"}, {"minimum", 0}};
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
    }
    return {};
}

// {"required": ["one"]}
Schema has(const std::vector<std::string>& keys) { return {{"required", keys}}; }

Schema element(const ElementType& type, bool must_say_type) {
    Schema properties = {{"type", {{"const", type.name}}}};
    std::vector<std::string> required;
    if (must_say_type) { required.emplace_back("type"); }
    for (const ElementKey& key : type.keys) {
        properties[key.name] = value(key.kind);
        properties[key.name]["description"] = meaning_of_key(key.name);
        if (key.required) { required.push_back(key.name); }
    }
    Schema schema = object(properties, required);
    schema["description"] = type.summary;
    for (const auto& [one, other, needed] : type.alternatives) {
        Schema rule = {{"not", has({one, other})}};
        if (needed) { rule = {{"oneOf", {has({one}), has({other})}}}; }
        schema["allOf"].push_back(rule);
    }
    return schema;
}

Schema element_list(ParameterKind kind, std::size_t least) {
    const ElementList& elements = elements_of(kind);
    Schema alternatives = Schema::array();
    for (const ElementType& type : elements.types) {
        alternatives.push_back(element(type, type.name != elements.standard));
    }
    return list({{"anyOf", alternatives}}, least);
}

Schema parameter(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::scalar:
            return one_or_list(number());
        case ParameterKind::positive:
            return one_or_list(positive());
        case ParameterKind::count:
            return one_or_list(integer(1, largest_parameter_count));
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

Schema problem_object(const ProblemDescription& problem) {
    Schema parameters = Schema::object();
    for (const ParameterDescription& description : problem.parameters) {
        parameters[description.name] = parameter(description.kind);
        parameters[description.name]["description"] = description.summary + " [" + description.unit + "]";
    }
    Schema label = text(200);
    label["not"] = {{"pattern", "^[=+@-]"}};
    const std::vector<std::string> required = required_parameters(problem);
    return object({{"name", {{"const", problem.name}}}, {"label", label}, {"parameters", object(parameters, required)}},
                  required.empty() ? std::vector<std::string>{"name"} : std::vector<std::string>{"name", "parameters"});
}

// Problems that a config can name without giving parameters.
std::vector<std::string> names_of_complete(const std::vector<ProblemDescription>& problems) {
    std::vector<std::string> names;
    for (const ProblemDescription& problem : problems) {
        if (required_parameters(problem).empty()) { names.push_back(problem.name); }
    }
    return names;
}

Schema option_value(const OptionDescription& option) {
    Schema alternatives = Schema::array();
    if (!option.choices.empty()) { alternatives.push_back(choice(option.choices)); }
    if (option.count_max >= option.count_min) { alternatives.push_back(integer(option.count_min, option.count_max)); }
    if (std::holds_alternative<bool>(option.standard)) { alternatives.push_back({{"type", "boolean"}}); }
    if (option.real_max >= option.real_min) {
        alternatives.push_back({{"type", "number"}, {"minimum", option.real_min}, {"maximum", option.real_max}});
    }
    return {{"anyOf", alternatives}};
}

template <class Description>
Schema optioned_object(const Description& description) {
    Schema properties = {{"name", {{"const", description.name}}}};
    for (const OptionDescription& option : description.options) {
        properties[option.name] = one_or_list(option_value(option));
        properties[option.name]["description"] = option.summary;
    }
    return object(properties, {"name"});
}

// `names`: what a text may be; an object is one of `all`.
template <class Description, class MakeObject>
Schema entries(const std::vector<std::string>& names, const std::vector<Description>& all,
               const MakeObject& make_object) {
    Schema alternatives = Schema::array({choice(names)});
    for (const Description& description : all) { alternatives.push_back(make_object(description)); }
    return list({{"anyOf", alternatives}});
}

template <class Description>
Schema optioned_entries(const std::vector<Description>& all) {
    std::vector<std::string> names = names_of(all);
    const auto wildcards = wildcards_of(all);
    names.insert(names.end(), wildcards.begin(), wildcards.end());
    return entries(names, all, optioned_object<Description>);
}

Schema time() {
    const Schema geometric =
        object({{"from", integer(1, largest_count)}, {"levels", integer(1, 64)}, {"factor", integer(2, 1000)}},
               {"from", "levels"});
    const Schema steps = {{"anyOf", {integer(1, largest_count), list(integer(1, largest_count)), geometric}}};
    Schema schema = object({{"end", positive()}, {"steps", steps}, {"step", one_or_list(positive())}}, {"end"});
    schema["oneOf"] = {{{"required", {"steps"}}}, {{"required", {"step"}}}};
    return schema;
}

std::vector<std::string> timed_kinds() {
    std::vector<std::string> names;
    for (const ExperimentKind& kind : experiment_kinds()) {
        if (kind.timed) { names.push_back(kind.name); }
    }
    return names;
}

// A kind whose cells are not timed, or no measurements besides the steps.
Schema not_timed() { return {{"properties", {{"kind", {{"not", {{"enum", timed_kinds()}}}}}}}}; }
Schema measures_nothing_else() {
    return {{"properties",
             {{"metrics", {{"maxItems", 0}}}, {"output", {{"properties", {{"samples", {{"maximum", 0}}}}}}}}}};
}

}  // namespace

Schema config_schema(const Registry& registry) {
    const Schema precision = choice({"double", "quad"});
    const Schema figure = figure_schema();
    Schema schema =
        object({{"name", {{"type", "string"}, {"pattern", "^[A-Za-z0-9_][A-Za-z0-9_.-]*$"}, {"maxLength", 100}}},
                {"description", text(2000)},
                {"kind", choice(names_of(experiment_kinds()))},
                {"precision", one_or_list(precision)},
                {"problems", entries(names_of_complete(registry.problems), registry.problems, problem_object)},
                {"formulations", list(choice(names_of(registry.formulations)))},
                {"methods", optioned_entries(registry.methods)},
                {"projections", optioned_entries(registry.projections)},
                {"time", time()},
                {"metrics", list(text(100), 0)},
                {"output", object({{"samples", integer(0, most_samples)}}, {})},
                {"figure", {{"anyOf", {figure, list(figure, 0)}}}}},
               {"name", "kind", "problems", "methods", "time"});
    schema["anyOf"] = Schema::array({not_timed(), measures_nothing_else()});
    schema["$schema"] = "http://json-schema.org/draft-07/schema#";
    schema["title"] = "kreisel config";
    return schema;
}

}  // namespace kreisel
