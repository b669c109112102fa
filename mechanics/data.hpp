// SPDX-License-Identifier: BSD-3-Clause
//
// A mechanical model as plain data, in SI units, as a user writes it down. Numbers are double here and are read as the
// decimals they print as (`decimal` in lie/real.hpp), so that double and quad integrate the same problem.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace kreisel {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<double, 9>;  ///< row by row

inline constexpr Matrix3 identity3 = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/// A rigid body: inertia about its mass centre in body axes (kg m^2), x and v in space axes (m, m/s), R body to
/// space, omega in body axes (rad/s). Without v, the velocity follows from the joints.
struct BodyData {
    std::string name;
    double mass = 1;
    Matrix3 inertia = identity3;
    Vector3 x = {0, 0, 0};
    Matrix3 R = identity3;
    std::optional<Vector3> v = {};
    Vector3 omega = {0, 0, 0};
    bool operator==(const BodyData&) const = default;
};

using ParameterValue = std::variant<double, Vector3, Matrix3, std::vector<BodyData>>;
using ParameterValues = std::map<std::string, ParameterValue>;

/// A parameter that describes no system. `path` is a JSON pointer below the parameters, such as "/inertia/2".
struct ParameterError : std::invalid_argument {
    std::string path;
    ParameterError(std::string where, const std::string& what) : std::invalid_argument(what), path(std::move(where)) {}
};

}  // namespace kreisel
