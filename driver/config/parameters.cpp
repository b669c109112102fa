// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "driver/config/model.hpp"
#include "driver/config/values.hpp"
#include "records/json/model_keys.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

constexpr std::size_t longest_label = 60;  // of a value in the label of a series

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

std::vector<ParameterValue> read_list(const Node& list, ParameterKind kind, const std::string& expected, bool each_once,
                                      const PrintedNumbers& printed) {
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
bool fit_together(const Axes& axes) {
    const std::size_t count = axes.front().values.size();
    for (const Axis& axis : axes) {
        if (axis.values.size() == count) { continue; }
        axis.node.violates(Rule::zipped,
                           fmt::format("{} values, as many as {} has, with which it varies", count, axes.front().name),
                           std::to_string(axis.values.size()));
        return false;
    }
    std::unordered_map<std::string, std::size_t> combinations;
    for (std::size_t i = 0; i < count; ++i) {
        std::string text;
        for (const Axis& axis : axes) { text += json_value(axis.values[i]) + ";"; }
        const auto [first, is_new] = combinations.emplace(text, i);
        if (is_new) { continue; }
        axes.front().node.violates(Rule::each_once, "each combination once",
                                   fmt::format("those at {} and {} are the same", first->second, i));
        return false;
    }
    return true;
}

std::vector<ParameterPoint> crossed(const std::vector<ParameterPoint>& points, const Axes& axes) {
    if (!fit_together(axes)) { return points; }
    const std::size_t count = axes.front().values.size();
    std::vector<ParameterPoint> all;
    for (const ParameterPoint& point : points) {
        for (std::size_t i = 0; i < count; ++i) {
            all.push_back(point);
            for (const Axis& axis : axes) { all.back().values[axis.name] = axis.values[i]; }
        }
    }
    return all;
}

/// Which of the values that a parameter takes each point has, from 1, by their texts.
std::unordered_map<std::string, std::size_t> numbered_values(const std::vector<ParameterPoint>& points,
                                                             const std::string& name) {
    std::unordered_map<std::string, std::size_t> numbers;
    for (const ParameterPoint& point : points) {
        numbers.emplace(json_value(point.values.at(name)), numbers.size() + 1);
    }
    return numbers;
}

/// Names the values of parameters that vary: numbers and vectors as they are, of what is longer which it is.
void label(std::vector<ParameterPoint>& points, const std::vector<std::string>& varying) {
    for (const std::string& name : varying) {
        const auto numbers = numbered_values(points, name);
        if (numbers.size() == 1) { continue; }
        for (ParameterPoint& point : points) {
            const std::string text = json_value(point.values.at(name));
            const bool is_short = text.size() <= longest_label;
            point.listed += fmt::format(", {} = {}", name, is_short ? text : fmt::format("#{}", numbers.at(text)));
        }
    }
}

}  // namespace

std::vector<ParameterPoint> read_parameters(const Node& written, const ProblemDescription& problem,
                                            const PrintedNumbers& printed) {
    std::vector<ParameterPoint> points = {{default_parameters(problem), ""}};
    if (!written.require_object("an object of parameters")) { return points; }
    written.only_keys(names_of(problem.parameters));
    std::vector<Axes> axes;  // in the order of the first parameter of each
    std::vector<std::string> varying;
    const auto add = [&](Axis axis) {
        varying.push_back(axis.name);
        const auto zipped = std::find_if(axes.begin(), axes.end(), [&](const Axes& some) {
            return !axis.zip.empty() && some.front().zip == axis.zip;
        });
        zipped == axes.end() ? axes.push_back({std::move(axis)}) : zipped->push_back(std::move(axis));
    };
    for (const ParameterDescription& parameter : problem.parameters) {
        const auto node = parameter.required ? written.require(parameter.name, expectation(parameter.kind))
                                             : written.find(parameter.name);
        if (!node) { continue; }
        if (node->is_object()) {
            add(read_axis(*node, parameter, printed));
        } else if (is_number(parameter.kind) && node->is_array()) {
            add(read_numbers(*node, parameter));
        } else if (const auto value = read_value(*node, parameter.kind, printed)) {
            points.front().values[parameter.name] = *value;
        }
    }
    for (const Axes& some : axes) {
        if (!some.front().values.empty()) { points = crossed(points, some); }
    }
    label(points, varying);
    return points;
}

}  // namespace kreisel
