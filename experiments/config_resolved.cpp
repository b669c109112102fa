// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "experiments/config.hpp"
#include "experiments/json_writer.hpp"

namespace kreisel {

namespace {

template <class Entries, class Write>
std::string list_of(const Entries& entries, const Write& write) {
    std::string text;
    for (const auto& entry : entries) { text += (text.empty() ? "" : ",") + write(entry); }
    return "[" + text + "]";
}

std::string problem_text(const ProblemEntry& problem) {
    return ObjectWriter()
        .member("name", json_text(problem.name))
        .member("label", json_text(problem.label))
        .member("parameters", json_value(problem.parameters))
        .text();
}

std::string optioned_text(const OptionedEntry& entry) {
    ObjectWriter object;
    object.member("name", json_text(entry.name));
    for (const auto& [name, value] : entry.options) { object.member(name, json_value(value)); }
    return object.text();
}

}  // namespace

std::string resolved_config(const Config& config) {
    ObjectWriter object;
    object.member("name", json_text(config.name));
    if (!config.description.empty()) { object.member("description", json_text(config.description)); }
    object.member("kind", json_text(config.kind)).member("precision", json_value(config.precisions));
    object.member("problems", list_of(config.problems, problem_text));
    object.member("formulations", json_value(config.formulations));
    object.member("methods", list_of(config.methods, optioned_text));
    object.member("projections", list_of(config.projections, optioned_text));
    const auto count = [](long value) { return fmt::format("{}", value); };
    object.member(
        "time",
        ObjectWriter().member("end", json_number(config.t_end)).member("steps", list_of(config.steps, count)).text());
    object.member("metrics", json_value(config.metrics));
    object.member("output", ObjectWriter().member("samples", count(config.samples)).text());
    if (!config.figure.is_null()) { object.member("figure", config.figure.dump()); }
    return object.text();
}

}  // namespace kreisel
