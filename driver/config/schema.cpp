// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/schema.hpp"

#include <nlohmann/json.hpp>

#include "driver/config/config.hpp"
#include "driver/config/keys/keys.hpp"
#include "driver/config/options.hpp"
#include "driver/config/reading/begin.hpp"
#include "driver/config/reading/figure_demands.hpp"
#include "driver/config/schema/figures.hpp"
#include "driver/config/schema/keys.hpp"
#include "driver/config/schema/problem.hpp"
#include "driver/config/schema/terms.hpp"
#include "driver/config/schema/text_option.hpp"
#include "plots/figures/schema.hpp"
#include "records/json/model_keys.hpp"
#include "records/json/node.hpp"
#include "records/json/writer.hpp"
#include "records/kinds/kind.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace schema {

namespace {

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
        const bool text = option.text != OptionText::none;
        properties[option.name] = text ? text_option(option.text) : one_or_set(option_value(option));
        properties[option.name]["description"] = option.summary;
        if (option.standard != OptionValue("")) {  // else there is none
            properties[option.name]["default"] = Schema::parse(json_value(option.standard));
        }
    }
    return object(properties, {"name"});
}

// `names`: what a text may be; an object is one of `all`.
template <class Description, class MakeObject>
Schema entries(const std::vector<std::string>& names, const std::vector<Description>& all,
               const MakeObject& make_object) {
    Schema alternatives = Schema::array({choice(names)});
    for (const Description& description : all) { alternatives.push_back(make_object(description)); }
    return set({{"anyOf", alternatives}});
}

template <class Description>
Schema optioned_entries(const std::vector<Description>& all) {
    std::vector<std::string> names = names_of(all);
    const auto wildcards = wildcards_of(all);
    names.insert(names.end(), wildcards.begin(), wildcards.end());
    return entries(names, all, optioned_object<Description>);
}

Schema series(const ConfigKeys& keys, const Schema& from) {
    return object_of(
        keys, {{"from", from}, {"levels", of_kind(level_count_kind())}, {"factor", of_kind(level_factor_kind())}});
}

Schema one_set_or_series(const Schema& one, const ConfigKeys& keys) {
    return {{"anyOf", {one, set(one), series(keys, one)}}};
}

// A number, or one in quotes with more digits than a double has.
Schema digits(const Schema& one, const char* pattern) {
    Schema quoted = text(64);
    quoted["pattern"] = pattern;
    return {{"anyOf", {one, quoted}}};
}

// A state, or the file of a sample.
Schema begin() {
    const Schema vector = list_of_three(digits(number(), digits_pattern));
    const Schema body =
        object_of(begin_body_keys(),
                  {{"name", text(64)}, {"x", vector}, {"R", list_of_three(vector)}, {"v", vector}, {"omega", vector}});
    const Schema turns = {{"type", "object"}, {"additionalProperties", integer(-largest_whole, largest_whole)}};
    const Schema state =
        object_of(begin_keys(),
                  {{"t", digits(not_negative(), positive_digits_pattern)}, {"bodies", list(body)}, {"turns", turns}});
    const Schema file = object_of(begin_file_keys(), {{"file", text(4096)}, {"t", not_negative()}});
    return {{"anyOf", {file, state}}};
}

Schema time() {
    Schema time =
        object_of(time_keys(), {{"begin", begin()},
                                {"end", of_kind(end_kind())},
                                {"steps", one_set_or_series(of_kind(step_count_kind()), step_series_keys())},
                                {"step", one_or_set(of_kind(step_kind()))},
                                {"tolerance", one_set_or_series(of_kind(tolerance_kind()), tolerance_series_keys())},
                                {"controller", of_kind(controller_kind())}});
    const auto has = [](const char* key) { return Schema{{"required", Schema::array({key})}}; };
    time["anyOf"] = Schema::array({has("steps"), has("step"), has("tolerance")});
    time["not"] = {{"required", {"steps", "step"}}};
    time["dependencies"] = {{"controller", Schema::array({"tolerance"})}};
    return time;
}

// A name of the engine, of a first integral, which problems have, or a pattern.
Schema metric() {
    Schema metric = text(100);
    metric["anyOf"] = {{{"enum", names_of_metrics()}}, {{"pattern", "^invariant[.]"}}, {{"pattern", "[*]"}}};
    return metric;
}

// A kind whose cells are not timed, or no measurements besides the steps, which are of one size.
Schema not_timed() { return {{"properties", {{"kind", {{"not", {{"enum", timed_kinds()}}}}}}}}; }
Schema measures_nothing_else() {
    return {{"properties",
             {{"metrics", {{"maxItems", 0}}},
              {"output", {{"properties", {{"samples", {{"maximum", 0}}}}}}},
              {"time", {{"not", {{"required", Schema::array({"tolerance"})}}}}}}}};
}

// With the names that there are to select; of a projection with options it is not known before the run.
Schema figure_of(const Catalogue& catalogue) {
    const auto one_or_several = [](const Schema& one) { return Schema{{"anyOf", {one, list(one)}}}; };
    const Schema formulation = choice(names_of(catalogue.formulations));
    Schema projection = text(200);
    projection["anyOf"] = {choice(names_of(catalogue.projections)), {{"pattern", " "}}};
    Schema figure = figure_schema();
    for (Schema& kind : figure["anyOf"]) {
        Schema& selected = kind["properties"]["select"]["properties"];
        selected["formulation"] = one_or_several(formulation);
        selected["projection"] = one_or_several(projection);
    }
    return figure;
}

// A config that extends another: any part of a config, since the rest of it stands in the other file.
Schema change_of_another() {
    Schema keys = {{"extends", text(4096)}};
    for (const ConfigKey& key : config_keys()) { keys[key.name] = Schema::object(); }
    return object(keys, {"extends"});
}

}  // namespace

}  // namespace schema

nlohmann::ordered_json config_schema(const Catalogue& catalogue) {
    using namespace schema;
    const Schema figure = figure_of(catalogue);
    const Schema output =
        object_of(output_keys(), {{"samples", of_kind(sample_count_kind())}, {"dense", of_kind(FlagKind())}});
    Schema config =
        object_of(config_keys(),
                  {{"name", {{"type", "string"}, {"pattern", "^[A-Za-z0-9_][A-Za-z0-9_.-]*$"}, {"maxLength", 100}}},
                   {"description", of_kind(description_kind())},
                   {"kind", of_kind(kind_of_experiment())},
                   {"precision", one_or_set(of_kind(precision_kind()))},
                   {"problems", entries(names_of_complete(catalogue.problems), catalogue.problems, problem_object)},
                   {"formulations", set(choice(names_of(catalogue.formulations)))},
                   {"methods", optioned_entries(catalogue.methods)},
                   {"projections", optioned_entries(catalogue.projections)},
                   {"time", time()},
                   {"metrics", set(metric(), 0)},
                   {"output", output},
                   {"figure", {{"anyOf", {figure, set(figure, 0)}}}}});
    config["anyOf"] = Schema::array({not_timed(), measures_nothing_else()});
    config["allOf"] = demands_of_figures();
    return {{"$schema", "http://json-schema.org/draft-07/schema#"},
            {"title", "kreisel config"},
            {"anyOf", {config, change_of_another()}}};
}

}  // namespace kreisel
