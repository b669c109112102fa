// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/reading/shapes.hpp"

#include <fmt/format.h>

#include "driver/config/catalogue.hpp"
#include "driver/config/values.hpp"
#include "records/json/model_keys.hpp"

namespace kreisel {

namespace {

std::optional<double> size_at(const Node& shape, const std::string& key) {
    const auto node = shape.find(key);
    return node ? node->positive(fmt::format("a {} greater than 0 (m)", key)) : std::nullopt;
}

std::optional<Vector3> edges_at(const Node& shape) {
    const auto node = shape.find("size");
    if (!node) { return std::nullopt; }
    const std::string expected = "three edges greater than 0 (m)";
    Vector3 edges{};
    if (!node->is_array() || node->json().size() != edges.size()) {
        node->mismatch(expected);
        return std::nullopt;
    }
    for (std::size_t i = 0; i < edges.size(); ++i) { edges[i] = node->element(i).positive(expected).value_or(0); }
    return edges;
}

std::optional<Vector3> axis_at(const Node& shape) {
    const std::string expected = "an axis: three numbers, not all 0";
    const auto node = shape.find("axis");
    const auto axis = node ? read_vector(*node, expected) : std::nullopt;
    if (axis == Vector3{0, 0, 0}) { node->mismatch(expected); }
    return axis;
}

// Nothing after an error.
std::optional<ShapeData> read_shape(const Node& node) {
    const std::string what = "a type of shape";
    if (!node.require_object("a shape: an object")) { return std::nullopt; }
    const auto type = node.require("type", fmt::format("{} ({})", what, listed(names_of(shape_types()))));
    const auto name = type ? type->name(what, names_of(shape_types())) : std::nullopt;
    if (!name) { return std::nullopt; }
    const ElementType& kind = *find_named(shape_types(), *name);
    node.only_keys(keys_of(kind), fmt::format(" of a shape of type {}", in_quotes(*name)));
    bool complete = true;
    for (const ElementKey& key : kind.keys) {
        if (key.required) { complete = node.require(key.name, expectation(key.kind)) && complete; }
    }
    if (!complete) { return std::nullopt; }
    return ShapeData{*name, size_at(node, "radius"), size_at(node, "length"), edges_at(node), axis_at(node)};
}

void add_shape(const Node& body, Shapes& shapes) {
    const auto written = body.json().is_object() ? body.find(shape_key) : std::nullopt;
    if (!written) { return; }
    const auto shape = read_shape(*written);
    const auto name = body.find("name");
    if (!shape || !name || !name->json().is_string()) { return; }
    const auto text = name->json().get<std::string>();
    const auto [known, is_new] = shapes.emplace(text, *shape);
    if (!is_new && known->second != *shape) {
        written->violates(Rule::own_name, "bodies of one name with one shape", "another for " + in_quotes(text));
    }
}

void add_shapes(const Node& bodies, Shapes& shapes) {
    if (!bodies.is_array()) { return; }
    for (const Node& body : bodies.elements_or_self()) { add_shape(body, shapes); }
}

}  // namespace

Shapes read_shapes(const Node& parameters, const ProblemDescription& problem) {
    Shapes shapes;
    if (!parameters.json().is_object()) { return shapes; }
    for (const ParameterDescription& parameter : problem.parameters) {
        const auto bodies = parameter.kind == ParameterKind::bodies ? parameters.find(parameter.name) : std::nullopt;
        if (!bodies) { continue; }
        const auto axis = bodies->is_object() ? bodies->find("axis") : std::nullopt;
        if (axis && axis->is_array()) {
            for (const Node& value : axis->elements_or_self()) { add_shapes(value, shapes); }
        } else {
            add_shapes(*bodies, shapes);
        }
    }
    return shapes;
}

}  // namespace kreisel
