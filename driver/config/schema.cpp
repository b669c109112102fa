// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/schema.hpp"

#include <nlohmann/json.hpp>

#include "driver/config/config.hpp"
#include "driver/config/options.hpp"
#include "driver/config/reading/figure_demands.hpp"
#include "driver/config/reading/measurements.hpp"
#include "driver/config/schema/figures.hpp"
#include "driver/config/schema/problem.hpp"
#include "driver/config/schema/terms.hpp"
#include "driver/config/schema/text_option.hpp"
#include "driver/config/time.hpp"
#include "plots/figures/schema.hpp"
#include "records/json/node.hpp"
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

Schema tolerance() {
    const Schema one = {{"type", "number"}, {"minimum", least_positive}, {"exclusiveMaximum", 1}};
    const Schema geometric =
        object({{"from", one}, {"levels", integer(1, 64)}, {"factor", integer(2, 1000)}}, {"from", "levels"});
    return {{"anyOf", {one, set(one), geometric}}};
}

Schema time() {
    const Schema geometric =
        object({{"from", integer(1, largest_count)}, {"levels", integer(1, 64)}, {"factor", integer(2, 1000)}},
               {"from", "levels"});
    const Schema steps = {{"anyOf", {integer(1, largest_count), set(integer(1, largest_count)), geometric}}};
    Schema time = object({{"end", positive()},
                          {"steps", steps},
                          {"step", one_or_set(positive())},
                          {"tolerance", tolerance()},
                          {"controller", choice(step_controllers())}},
                         {"end"});
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
    for (const std::string& key : config_keys()) { keys[key] = Schema::object(); }
    return object(keys, {"extends"});
}

}  // namespace

}  // namespace schema

nlohmann::ordered_json config_schema(const Catalogue& catalogue) {
    using namespace schema;
    const Schema precision = choice({"double", "quad"});
    const Schema figure = figure_of(catalogue);
    Schema config =
        object({{"name", {{"type", "string"}, {"pattern", "^[A-Za-z0-9_][A-Za-z0-9_.-]*$"}, {"maxLength", 100}}},
                {"description", text(2000)},
                {"kind", choice(names_of(experiment_kinds()))},
                {"precision", one_or_set(precision)},
                {"problems", entries(names_of_complete(catalogue.problems), catalogue.problems, problem_object)},
                {"formulations", set(choice(names_of(catalogue.formulations)))},
                {"methods", optioned_entries(catalogue.methods)},
                {"projections", optioned_entries(catalogue.projections)},
                {"time", time()},
                {"metrics", set(metric(), 0)},
                {"output", object({{"samples", integer(0, most_samples)}, {"dense", {{"type", "boolean"}}}}, {})},
                {"figure", {{"anyOf", {figure, set(figure, 0)}}}}},
               {"name", "kind", "problems", "methods", "time"});
    config["anyOf"] = Schema::array({not_timed(), measures_nothing_else()});
    config["allOf"] = demands_of_figures();
    return {{"$schema", "http://json-schema.org/draft-07/schema#"},
            {"title", "kreisel config"},
            {"anyOf", {config, change_of_another()}}};
}

}  // namespace kreisel
