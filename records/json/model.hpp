// SPDX-License-Identifier: BSD-3-Clause
//
// The entries of a mechanism as JSON, and the shapes of its bodies.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/model/data.hpp"
#include "mechanics/parts/keys.hpp"
#include "records/json/exact.hpp"

namespace kreisel {

/// As a config writes them, with every default that is a value; they read back to the same data.
std::string json_element(const BodyData& body);
std::string json_element(const JointData& joint);
std::string json_element(const ForceData& force);

// The shapes that a config gives bodies: drawings need them, and nothing that is computed. They are not parameters of a
// problem, and name no cell.

/// About the mass centre, m, body axes. `type`: "cylinder" or "rod" (`length` along `axis`, and a radius, which a rod
/// need not have), "box" (`size`: edges along the body axes), "sphere" (`radius`).
struct ShapeData {
    std::string type;
    std::optional<double> radius = {}, length = {};
    std::optional<Vector3> size = {}, axis = {};
    bool operator==(const ShapeData&) const = default;
};

using Shapes = std::map<std::string, ShapeData>;  ///< by the names of bodies

/// The key of a body, what it means, and which bodies may have it: rigid ones.
inline constexpr const char* shape_key = "shape";
extern const char* const shape_meaning;
bool may_have_shape(const ElementType& body);

/// The types of shapes with their keys: numbers greater than 0 and vectors.
const std::vector<ElementType>& shape_types();

/// As a config writes it.
std::string json_shape(const ShapeData& shape);
/// Throws std::invalid_argument.
ShapeData shape_of_json(const JsonValue& json);

/// Bodies with their shapes, as a config writes them; other values as they are.
std::string json_with_shapes(const ParameterValue& value, const Shapes& shapes);

}  // namespace kreisel
