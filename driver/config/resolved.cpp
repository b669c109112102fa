// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/resolved.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "records/begin.hpp"
#include "records/json/model.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

template <class Entries, class Write>
std::string list_text(const Entries& entries, const Write& write) {
    std::string text;
    for (const auto& entry : entries) { text += (text.empty() ? "" : ",") + write(entry); }
    return "[" + text + "]";
}

// Whether lists of numbers make these problems, all of them crossed.
bool are_crossed_numbers(const ProblemSeries& problems) {
    std::size_t count = 1;
    for (const VaryingParameter& varying : problems.varying()) {
        if (varying.distinct() > 1 && !varying.holds_numbers()) { return false; }
        count *= varying.distinct();
    }
    return count == problems.size();
}

std::string written_text(const ProblemSeries& problems, const VaryingParameter& varying, std::size_t place) {
    return json_with_shapes(varying.value(place), problems.shapes());
}

// The values that a parameter takes, each once; or those of all problems in their order.
std::vector<std::string> distinct_texts(const ProblemSeries& problems, const VaryingParameter& varying) {
    std::vector<std::string> texts;
    for (std::size_t place = 0; place < problems.places(varying.axis()); ++place) {
        if (varying.rank(place) == texts.size() + 1) { texts.push_back(written_text(problems, varying, place)); }
    }
    return texts;
}

std::vector<std::string> all_texts(const ProblemSeries& problems, const VaryingParameter& varying) {
    std::vector<std::string> texts;
    for (std::size_t point = 0; point < problems.size(); ++point) {
        texts.push_back(written_text(problems, varying, problems.place(point, varying.axis())));
    }
    return texts;
}

bool varies_with_others(const ProblemSeries& problems) {
    const auto& all = problems.varying();
    return std::count_if(all.begin(), all.end(), [](const auto& one) { return one.distinct() > 1; }) > 1;
}

// A list of numbers, or an axis that varies with all others, if there are any.
std::string varying_text(const ProblemSeries& problems, const VaryingParameter& varying, bool crossed) {
    const auto as_it_is = [](const std::string& text) { return text; };
    if (varying.distinct() == 1) { return written_text(problems, varying, 0); }
    if (crossed) { return list_text(distinct_texts(problems, varying), as_it_is); }
    ObjectWriter axis;
    axis.member("axis", list_text(all_texts(problems, varying), as_it_is));
    if (varies_with_others(problems)) { axis.member("zip", json_text("all")); }
    return axis.text();
}

// The problems of one entry as that entry.
std::string problem_text(const ProblemSeries& problems) {
    const bool crossed = are_crossed_numbers(problems);
    std::map<std::string, std::string> texts;
    for (const auto& [name, value] : problems.common_parameters()) {
        texts[name] = json_with_shapes(value, problems.shapes());
    }
    for (const VaryingParameter& one : problems.varying()) { texts[one.name()] = varying_text(problems, one, crossed); }
    ObjectWriter parameters;
    for (const auto& [name, text] : texts) { parameters.member(name, text); }
    return ObjectWriter()
        .member("name", json_text(problems.problem()))
        .member("label", json_text(problems.label()))
        .member("parameters", parameters.text())
        .text();
}

std::string problems_text(const std::vector<ProblemPoint>& problems) {
    std::vector<const ProblemSeries*> entries;
    for (const ProblemPoint& problem : problems) {
        if (entries.empty() || entries.back() != problem.series().get()) { entries.push_back(problem.series().get()); }
    }
    return list_text(entries, [](const ProblemSeries* entry) { return problem_text(*entry); });
}

std::string optioned_text(const OptionedEntry& entry) {
    ObjectWriter object;
    object.member("name", json_text(entry.name));
    for (const auto& [name, value] : entry.options) { object.member(name, json_value(value)); }
    return object.text();
}

std::string count_text(long value) { return fmt::format("{}", value); }

std::string time_text(const Config& config) {
    ObjectWriter time;
    if (config.begin) { time.member("begin", json_begin(*config.begin)); }
    time.member("end", json_number(config.t_end));
    if (!config.steps.empty()) { time.member("steps", list_text(config.steps, count_text)); }
    if (!config.tolerances.empty()) {
        time.member("tolerance", list_text(config.tolerances, json_number));
        time.member("controller", json_text(config.controller));
    }
    return time.text();
}

}  // namespace

std::string resolved_config(const Config& config) {
    ObjectWriter object;
    object.member("name", json_text(config.name));
    if (!config.description.empty()) { object.member("description", json_text(config.description)); }
    object.member("kind", json_text(config.kind)).member("precision", json_value(config.precisions));
    object.member("problems", problems_text(config.problems));
    object.member("formulations", json_value(config.formulations));
    object.member("methods", list_text(config.methods, optioned_text));
    object.member("projections", list_text(config.projections, optioned_text));
    object.member("time", time_text(config)).member("metrics", json_value(config.metrics));
    ObjectWriter output;
    output.member("samples", count_text(config.samples));
    if (!config.dense) { output.member("dense", "false"); }
    object.member("output", output.text());
    if (!config.figure.empty()) { object.member("figure", config.figure); }
    return object.text();
}

}  // namespace kreisel
