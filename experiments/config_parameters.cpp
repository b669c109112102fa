// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <set>

#include "experiments/config_parts.hpp"
#include "experiments/nearest.hpp"

namespace kreisel {

namespace {

constexpr const char* vector_expected = "three numbers";
constexpr const char* rotation_expected = "a rotation matrix: three rows of three numbers";
constexpr const char* inertia_expected =
    "an inertia: three numbers, or a symmetric matrix of three rows of three numbers";

std::optional<Vector3> read_vector(const Node& node, const std::string& expected) {
    if (!node.is_array() || node.json().size() != 3) {
        node.mismatch(expected);
        return std::nullopt;
    }
    Vector3 vector{};
    bool good = true;
    const auto components = node.elements_or_self();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto number = components[i].number();
        good = good && number;
        vector[i] = number.value_or(0);
    }
    return good ? std::optional(vector) : std::nullopt;
}

std::optional<Matrix3> read_matrix(const Node& node, const std::string& expected) {
    if (!node.is_array() || node.json().size() != 3) {
        node.mismatch(expected);
        return std::nullopt;
    }
    Matrix3 matrix{};
    bool good = true;
    const auto rows = node.elements_or_self();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = read_vector(rows[i], expected);
        good = good && row;
        for (std::size_t j = 0; j < 3 && row; ++j) { matrix[3 * i + j] = (*row)[j]; }
    }
    return good ? std::optional(matrix) : std::nullopt;
}

std::optional<Matrix3> read_inertia(const Node& node) {
    const bool diagonal = node.is_array() && !node.json().empty() && !node.json().front().is_array();
    if (diagonal) {
        const auto moments = read_vector(node, inertia_expected);
        return moments ? std::optional(Matrix3{(*moments)[0], 0, 0, 0, (*moments)[1], 0, 0, 0, (*moments)[2]})
                       : std::nullopt;
    }
    auto matrix = read_matrix(node, inertia_expected);
    if (matrix && ((*matrix)[1] != (*matrix)[3] || (*matrix)[2] != (*matrix)[6] || (*matrix)[5] != (*matrix)[7])) {
        node.error(inertia_expected, "a matrix that is not symmetric");
        return std::nullopt;
    }
    return matrix;
}

template <class Value>
void assign(Value& target, const std::optional<Value>& value) {
    if (value) { target = *value; }
}

BodyData read_body(const Node& node) {
    BodyData body;
    if (!node.require_object("a body: an object with the keys " + listed(body_keys()))) { return body; }
    node.only_keys(body_keys());
    if (const auto name = node.require("name", "the body's name")) {
        assign(body.name, name->text("the body's name", 64));
    }
    if (const auto mass = node.require("mass", "a number greater than 0 (kg)")) {
        assign(body.mass, mass->positive("a mass greater than 0 (kg)"));
    }
    if (const auto inertia = node.require("inertia", inertia_expected)) {
        assign(body.inertia, read_inertia(*inertia));
    }
    if (const auto x = node.require("x", "the mass centre, three numbers (m)")) {
        assign(body.x, read_vector(*x, vector_expected));
    }
    if (const auto rotation = node.find("R")) { assign(body.R, read_matrix(*rotation, rotation_expected)); }
    if (const auto v = node.find("v")) { body.v = read_vector(*v, vector_expected); }
    if (const auto omega = node.find("omega")) { assign(body.omega, read_vector(*omega, vector_expected)); }
    return body;
}

std::optional<ParameterValue> read_bodies(const Node& node) {
    const auto entries = node.elements("a list of bodies");
    if (!entries) { return std::nullopt; }
    std::vector<BodyData> bodies;
    std::set<std::string> names;
    for (const Node& entry : *entries) {
        bodies.push_back(read_body(entry));
        if (!bodies.back().name.empty() && !names.insert(bodies.back().name).second) {
            entry.error("bodies with different names", "a second " + in_quotes(bodies.back().name));
        }
    }
    return bodies;
}

std::optional<ParameterValue> read_value(const Node& node, ParameterKind kind) {
    const auto widened = [](auto value) { return value ? std::optional<ParameterValue>(*value) : std::nullopt; };
    switch (kind) {
        case ParameterKind::scalar:
            return widened(node.number());
        case ParameterKind::positive:
            return widened(node.positive());
        case ParameterKind::vector:
            return widened(read_vector(node, vector_expected));
        case ParameterKind::inertia:
            return widened(read_inertia(node));
        case ParameterKind::rotation:
            return widened(read_matrix(node, rotation_expected));
        case ParameterKind::bodies:
            return read_bodies(node);
    }
    return std::nullopt;
}

}  // namespace

const std::vector<std::string>& body_keys() {
    static const std::vector<std::string> keys = {"name", "mass", "inertia", "x", "R", "v", "omega"};
    return keys;
}

std::string expectation(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::scalar:
            return "a number";
        case ParameterKind::positive:
            return "a number greater than 0";
        case ParameterKind::vector:
            return vector_expected;
        case ParameterKind::inertia:
            return inertia_expected;
        case ParameterKind::rotation:
            return rotation_expected;
        case ParameterKind::bodies:
            return "a list of bodies, each an object with the keys " + listed(body_keys());
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
            assign(values[parameter.name], read_value(*node, parameter.kind));
        }
    }
    return values;
}

}  // namespace kreisel
