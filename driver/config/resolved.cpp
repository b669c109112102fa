// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/resolved.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "records/json/writer.hpp"

namespace kreisel {

namespace {

template <class Entries, class Write>
std::string list_text(const Entries& entries, const Write& write) {
    std::string text;
    for (const auto& entry : entries) { text += (text.empty() ? "" : ",") + write(entry); }
    return "[" + text + "]";
}

// The texts of the values that a parameter takes among entries, in order of first appearance.
std::vector<std::string> texts_of(const std::vector<ProblemEntry>& entries, const std::string& name) {
    std::vector<std::string> texts;
    std::unordered_set<std::string> known;
    for (const ProblemEntry& entry : entries) {
        std::string text = json_value(entry.parameters.at(name));
        if (known.insert(text).second) { texts.push_back(std::move(text)); }
    }
    return texts;
}

// Whether lists of numbers make these entries, all of them crossed.
bool are_crossed_numbers(const std::vector<ProblemEntry>& entries) {
    std::size_t count = 1;
    for (const auto& [name, value] : entries.front().parameters) {
        const std::size_t values = texts_of(entries, name).size();
        if (values > 1 && !std::holds_alternative<double>(value)) { return false; }
        count *= values;
    }
    return count == entries.size();
}

// The value of a parameter, a list of numbers, or an axis that varies with all others.
std::string parameter_text(const std::vector<ProblemEntry>& entries, const std::string& name, bool crossed) {
    const std::vector<std::string> texts = texts_of(entries, name);
    if (texts.size() == 1) { return texts.front(); }
    const auto as_it_is = [](const std::string& text) { return text; };
    if (crossed) { return list_text(texts, as_it_is); }
    const std::string axis =
        list_text(entries, [&](const ProblemEntry& entry) { return json_value(entry.parameters.at(name)); });
    return ObjectWriter().member("axis", axis).member("zip", json_text("all")).text();
}

// Entries that came from one, as one again.
std::string problem_text(const std::vector<ProblemEntry>& entries) {
    const ProblemEntry& first = entries.front();
    const bool crossed = are_crossed_numbers(entries);
    ObjectWriter parameters;
    for (const auto& entry : first.parameters) {
        parameters.member(entry.first, parameter_text(entries, entry.first, crossed));
    }
    return ObjectWriter()
        .member("name", json_text(first.name))
        .member("label", json_text(first.series))
        .member("parameters", parameters.text())
        .text();
}

std::vector<std::vector<ProblemEntry>> as_written(const std::vector<ProblemEntry>& problems) {
    std::vector<std::vector<ProblemEntry>> entries;
    for (const ProblemEntry& problem : problems) {
        if (entries.empty() || entries.back().front().pointer != problem.pointer) { entries.emplace_back(); }
        entries.back().push_back(problem);
    }
    return entries;
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
    object.member("problems", list_text(as_written(config.problems), problem_text));
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
