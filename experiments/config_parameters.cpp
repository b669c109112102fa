// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/config_parts.hpp"
#include "experiments/model_keys.hpp"

namespace kreisel {

namespace {

std::optional<ParameterValue> read_value(const Node& node, ParameterKind kind) {
    const auto widened = [](auto value) { return value ? std::optional<ParameterValue>(*value) : std::nullopt; };
    switch (kind) {
        case ParameterKind::scalar:
            return widened(node.number());
        case ParameterKind::positive:
            return widened(node.positive());
        case ParameterKind::vector:
            return widened(read_vector(node, expectation(kind)));
        case ParameterKind::inertia:
            return widened(read_inertia(node));
        case ParameterKind::rotation:
            return widened(read_matrix(node, expectation(kind)));
        case ParameterKind::bodies:
            return read_bodies(node);
        case ParameterKind::joints:
            return read_joints(node);
        case ParameterKind::forces:
            return read_forces(node);
        case ParameterKind::flag:
            return widened(node.flag());
    }
    return std::nullopt;
}

}  // namespace

std::string expectation(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::scalar:
            return "a number";
        case ParameterKind::positive:
            return "a number greater than 0";
        case ParameterKind::vector:
            return expectation(ValueKind::vector);
        case ParameterKind::inertia:
            return expectation(ValueKind::inertia);
        case ParameterKind::rotation:
            return expectation(ValueKind::matrix);
        case ParameterKind::bodies:
            return "a list of bodies, at least one";
        case ParameterKind::joints:
            return "a list of joints";
        case ParameterKind::forces:
            return "a list of forces";
        case ParameterKind::flag:
            return "true or false";
    }
    return "";
}

ParameterValues default_parameters(const ProblemDescription& problem) {
    ParameterValues values;
    for (const ParameterDescription& parameter : problem.parameters) { values[parameter.name] = parameter.standard; }
    return values;
}

ParameterValues read_parameters(const Node& written, const ProblemDescription& problem) {
    ParameterValues values = default_parameters(problem);
    if (!written.require_object("an object of parameters")) { return values; }
    written.only_keys(names_of(problem.parameters));
    for (const ParameterDescription& parameter : problem.parameters) {
        if (const auto node = written.find(parameter.name)) {
            if (const auto value = read_value(*node, parameter.kind)) { values[parameter.name] = *value; }
        }
    }
    return values;
}

}  // namespace kreisel
