// SPDX-License-Identifier: BSD-3-Clause
//
// A mechanism that is sound, what changes make of it, and how it is refused.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"
#include "support/errors.hpp"

namespace kreisel::mechanism_tests {

using nlohmann::ordered_json;

inline const Engines engines{engine_binary64(), engine_binary64()};

/// Two rods of a chain and a bob: straight along x, at rest.
inline const char* const chain = R"({
    "gravity": [0, 0, -9.81], "forces": [],
    "bodies": [{"name": "crank", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [0.5, 0, 0]},
               {"name": "rod", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [1.5, 0, 0]},
               {"type": "point", "name": "bob", "mass": 1, "x": [2, 0, 0]}],
    "joints": [{"type": "revolute", "between": ["ground", "crank"], "point": [0, 0, 0], "axis": [0, 1, 0]},
               {"type": "spherical", "between": ["crank", "rod"], "point": [1, 0, 0]},
               {"type": "spherical", "between": ["rod", "bob"], "point": [2, 0, 0]}]})";

inline Plan plan_with(const ordered_json& parameters) {
    ordered_json config = {
        {"name", "mechanism"}, {"kind", "trajectory"}, {"methods", {"rkmk/rk4"}}, {"metrics", ordered_json::array()}};
    config["problems"] = {{{"name", "multibody"}, {"parameters", parameters}}};
    config["formulations"] = {"SO3xR3", "SE3", "S3xR3"};
    config["time"] = {{"end", 1}, {"steps", 100}};
    return plan_of(parse_document("mechanism.json", config.dump(1)), engines);
}

/// The chain with values put into places of it, pointers and JSON.
inline ordered_json changed(const std::vector<std::pair<std::string, std::string>>& changes) {
    ordered_json parameters = ordered_json::parse(chain);
    for (const auto& [place, value] : changes)
        parameters[ordered_json::json_pointer(place)] = ordered_json::parse(value);
    return parameters;
}

/// Empty where it is admissible.
inline std::string refusal(const ordered_json& parameters) {
    try {
        plan_with(parameters);
        return "";
    } catch (const UsageError& error) { return error.what(); }
}

}  // namespace kreisel::mechanism_tests
