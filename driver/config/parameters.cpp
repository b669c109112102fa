// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "driver/config/model.hpp"
#include "driver/config/values.hpp"
#include "records/json/model_keys.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

std::optional<ParameterValue> read_count(const Node& node) {
    const auto count = node.count(1, largest_parameter_count, "parts");
    return count ? std::optional<ParameterValue>(static_cast<double>(*count)) : std::nullopt;
}

std::optional<ParameterValue> read_value(const Node& node, ParameterKind kind) {
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
            return widened(read_inertia(node));
        case ParameterKind::rotation:
            return widened(read_matrix(node, expectation(kind)));
        case ParameterKind::bodies:
            return parse_bodies(node);
        case ParameterKind::joints:
            return parse_joints(node);
        case ParameterKind::forces:
            return parse_forces(node);
        case ParameterKind::flag:
            return widened(node.flag());
    }
    return std::nullopt;
}

bool is_number(ParameterKind kind) {
    return kind == ParameterKind::scalar || kind == ParameterKind::positive || kind == ParameterKind::count;
}

std::vector<double> read_list(const Node& list, ParameterKind kind) {
    std::vector<double> values;
    std::unordered_set<double> known;
    for (const Node& entry :
         list.elements(expectation(kind) + ", or a list of such numbers").value_or(std::vector<Node>())) {
        const auto value = read_value(entry, kind);
        if (!value) { continue; }
        const double number = std::get<double>(*value);
        if (!known.insert(number).second) {
            entry.error("each value once", json_number(number) + " again");
        } else {
            values.push_back(number);
        }
    }
    return values;
}

std::vector<ParameterPoint> crossed(const std::vector<ParameterPoint>& points, const std::string& name,
                                    const std::vector<double>& values) {
    std::vector<ParameterPoint> all;
    for (const ParameterPoint& point : points) {
        for (const double value : values) {
            all.push_back(point);
            all.back().values[name] = value;
            if (values.size() > 1) { all.back().listed += ", " + name + " = " + json_number(value); }
        }
    }
    return all;
}

}  // namespace

std::vector<ParameterPoint> read_parameters(const Node& written, const ProblemDescription& problem) {
    std::vector<ParameterPoint> points = {{default_parameters(problem), ""}};
    if (!written.require_object("an object of parameters")) { return points; }
    written.only_keys(names_of(problem.parameters));
    for (const ParameterDescription& parameter : problem.parameters) {
        const auto node = parameter.required ? written.require(parameter.name, expectation(parameter.kind))
                                             : written.find(parameter.name);
        if (!node) { continue; }
        if (is_number(parameter.kind) && node->is_array()) {
            points = crossed(points, parameter.name, read_list(*node, parameter.kind));
        } else if (const auto value = read_value(*node, parameter.kind)) {
            for (ParameterPoint& point : points) { point.values[parameter.name] = *value; }
        }
    }
    return points;
}

}  // namespace kreisel
