// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "driver/config/model.hpp"
#include "driver/config/values.hpp"
#include "records/json/diagnostics.hpp"
#include "records/json/model_keys.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

std::optional<ParameterValue> read_count(const Node& node) {
    const auto count = node.count(1, largest_parameter_count, "parts");
    return count ? std::optional<ParameterValue>(static_cast<double>(*count)) : std::nullopt;
}

std::optional<ParameterValue> read_value(const Node& node, ParameterKind kind, const PrintedNumbers& printed) {
    const auto widened = [](auto value) { return value ? std::optional<ParameterValue>(*value) : std::nullopt; };
    switch (kind) {
        case ParameterKind::scalar:
            return widened(node.number());
        case ParameterKind::positive:
            return widened(node.positive());
        case ParameterKind::count:
            return read_count(node);
        case ParameterKind::vector:
            return widened(read_vector(node, expectation(kind)));
        case ParameterKind::inertia:
            return widened(read_inertia(node, printed));
        case ParameterKind::rotation:
            return widened(read_rotation(node, printed));
        case ParameterKind::bodies:
            return parse_bodies(node, printed);
        case ParameterKind::joints:
            return parse_joints(node);
        case ParameterKind::forces:
            return parse_forces(node, printed);
        case ParameterKind::flag:
            return widened(node.flag());
    }
    return std::nullopt;
}

bool is_number(ParameterKind kind) {
    return kind == ParameterKind::scalar || kind == ParameterKind::positive || kind == ParameterKind::count;
}

/// A parameter of which cells take one value after the other.
struct Axis {
    std::string name;
    std::vector<ParameterValue> values;
    std::string zip = {};  ///< axes of one name vary together
    Node node;
};
using Axes = std::vector<Axis>;
using Together = std::vector<const Axis*>;  // axes that vary together

// Whether a list has nothing but numbers, no two of them equal: then its values need not be compared one by one.
bool has_distinct_numbers(const Node& list) {
    if (!list.is_array() || list.json().empty()) { return false; }
    std::vector<double> numbers;
    for (const auto& entry : list.json()) {
        if (!entry.is_number()) { return false; }
        numbers.push_back(entry.get<double>());
    }
    std::sort(numbers.begin(), numbers.end());
    return std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end();
}

std::vector<ParameterValue> read_distinct_numbers(const Node& list, ParameterKind kind) {
    std::vector<ParameterValue> values;
    values.reserve(list.json().size());
    for (std::size_t i = 0; i < list.json().size(); ++i) {
        if (const auto value = read_value(list.element(i), kind, PrintedNumbers())) { values.push_back(*value); }
    }
    return values;
}

std::vector<ParameterValue> read_list(const Node& list, ParameterKind kind, const std::string& expected, bool each_once,
                                      const PrintedNumbers& printed) {
    if (is_number(kind) && has_distinct_numbers(list)) { return read_distinct_numbers(list, kind); }
    std::vector<ParameterValue> values;
    std::unordered_set<std::string> known;
    const std::vector<Node> entries = list.elements(expected).value_or(std::vector<Node>());
    for (const Node& entry : each_once ? distinct(entries, "value") : entries) {
        const auto value = read_value(entry, kind, printed);
        if (!value) { continue; }
        if (std::string text = json_value(*value); each_once && !known.insert(text).second) {
            entry.violates(Rule::each_once, "each value once", text + " again");
        } else {
            values.push_back(*value);
        }
    }
    return values;
}

/// {"axis": [...], "zip": "name"}.
Axis read_axis(const Node& node, const ParameterDescription& parameter, const PrintedNumbers& printed) {
    Axis axis{.name = parameter.name, .node = node};
    node.only_keys({"axis", "zip"}, " of an axis");
    if (const auto zip = node.find("zip")) {
        axis.zip = zip->text("a name that axes share which vary together", 64).value_or("");
    }
    const std::string expected = "a list of values: " + expectation(parameter.kind) + " each";
    if (const auto list = node.require("axis", expected)) {
        axis.values = read_list(*list, parameter.kind, expected, axis.zip.empty(), printed);
    }
    return axis;
}

/// Of a number a list is enough.
Axis read_numbers(const Node& node, const ParameterDescription& parameter) {
    const std::string expected = expectation(parameter.kind) + ", or a list of such numbers";
    return {.name = parameter.name,
            .values = read_list(node, parameter.kind, expected, true, PrintedNumbers()),
            .node = node};
}

/// Whether all axes of a zip have as many values as the first, and no combination comes twice.
bool fit_together(const Together& axes) {
    const Axis& first = *axes.front();
    const std::size_t count = first.values.size();
    for (const Axis* axis : axes) {
        if (axis->values.size() == count) { continue; }
        axis->node.violates(Rule::zipped,
                            fmt::format("{} values, as many as {} has, with which it varies", count, first.name),
                            std::to_string(axis->values.size()));
        return false;
    }
    if (first.zip.empty()) { return true; }  // each value is there once
    std::unordered_map<std::string, std::size_t> combinations;
    for (std::size_t i = 0; i < count; ++i) {
        std::string text;
        for (const Axis* axis : axes) { text += json_value(axis->values[i]) + ";"; }
        const auto [place, is_new] = combinations.emplace(text, i);
        if (is_new) { continue; }
        first.node.violates(Rule::each_once, "each combination once",
                            fmt::format("those at {} and {} are the same", place->second, i));
        return false;
    }
    return true;
}

/// The axes of each zip, in the order of the first parameter of each.
std::vector<Together> zipped(const Axes& all) {
    std::vector<Together> groups;
    for (const Axis& axis : all) {
        const auto group = std::find_if(groups.begin(), groups.end(), [&](const Together& some) {
            return !axis.zip.empty() && some.front()->zip == axis.zip;
        });
        group == groups.end() ? groups.push_back({&axis}) : group->push_back(&axis);
    }
    return groups;
}

// An axis alone in its zip is crossed with all others, which its name does not look like.
void warn_of_lonely(const Together& axes) {
    const Axis& first = *axes.front();
    if (first.zip.empty() || axes.size() > 1) { return; }
    first.node.warn(
        fmt::format("no other axis here has the zip {}: this one is crossed with the others", in_quotes(first.zip)));
}

// Axes without values, or that do not fit together, have been told; they make no problems.
void vary(Axes all, ReadParameters& parameters) {
    std::map<std::string, std::size_t> axis_of;  // by parameter
    for (const Together& some : zipped(all)) {
        const std::size_t count = some.front()->values.size();
        if (count == 0 || !fit_together(some)) { continue; }
        warn_of_lonely(some);
        for (const Axis* axis : some) { axis_of[axis->name] = parameters.axes.size(); }
        parameters.axes.push_back(count);
    }
    for (Axis& axis : all) {
        const auto number = axis_of.find(axis.name);
        if (number == axis_of.end()) { continue; }
        parameters.values[axis.name] = axis.values.front();
        parameters.varying.emplace_back(axis.name, number->second, std::move(axis.values));
    }
}

}  // namespace

ReadParameters read_parameters(const Node& written, const ProblemDescription& problem, const PrintedNumbers& printed) {
    ReadParameters parameters{default_parameters(problem)};
    if (!written.require_object("an object of parameters")) { return parameters; }
    written.only_keys(names_of(problem.parameters));
    Axes axes;
    for (const ParameterDescription& parameter : problem.parameters) {
        const auto node = parameter.required ? written.require(parameter.name, expectation(parameter.kind))
                                             : written.find(parameter.name);
        if (!node) { continue; }
        if (node->is_object()) {
            axes.push_back(read_axis(*node, parameter, printed));
        } else if (is_number(parameter.kind) && node->is_array()) {
            axes.push_back(read_numbers(*node, parameter));
        } else if (const auto value = read_value(*node, parameter.kind, printed)) {
            parameters.values[parameter.name] = *value;
        }
    }
    vary(std::move(axes), parameters);
    return parameters;
}

}  // namespace kreisel
