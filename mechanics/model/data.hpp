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
/// space, omega in body axes (rad/s). A velocity that is not given follows from the joints. A point mass has no
/// inertia; its R and omega have no meaning.
struct BodyData {
    std::string name;
    double mass = 1;
    Matrix3 inertia = identity3;
    Vector3 x = {0, 0, 0};
    Matrix3 R = identity3;
    std::optional<Vector3> v = {}, omega = {};
    bool point = false;
    bool operator==(const BodyData&) const = default;
};

/// amplitude sin(frequency t + phase): amplitude in the unit of the coordinate, frequency in rad/s, phase in rad.
struct SinusoidData {
    double amplitude = 0, frequency = 0, phase = 0;
    bool operator==(const SinusoidData&) const = default;
};

/// A prescribed coordinate, f(t) = sum_k polynomial_k t^k + the sum of the sinusoids, in rad or m.
struct MotionData {
    std::vector<double> polynomial = {};
    std::vector<SinusoidData> sinusoids = {};
    bool operator==(const MotionData&) const = default;
};

/// A joint between two named bodies, or a body and "ground". `type` is the name of a joint (mechanics/parts/joints/),
/// such as "revolute". Points (m) and axes in space coordinates of the initial configuration, one for each body.
/// `length` (m): of a distance joint, by default the initial one; of a rolling joint, the radius. The length of a
/// distance joint is length (1 + amplitude sin(frequency t)), frequency in rad/s. `turn` (rad) and `shift` (m)
/// prescribe coordinates of the second body relative to the first, about and along the second axis, from the
/// configuration as given. `lead` (m): of a screw, its shift in one turn. `teeth`: of the two wheels of a gear, below 0
/// of a ring with its teeth inside.
struct JointData {
    std::string type = "spherical";
    std::array<std::string, 2> between = {};
    std::array<Vector3, 2> points = {};
    std::array<Vector3, 2> axes = {};
    std::optional<double> length = {};
    double amplitude = 0, frequency = 0;
    std::optional<MotionData> turn = {}, shift = {};
    std::optional<double> lead = {};
    std::array<long, 2> teeth = {0, 0};
    std::string name = {};  ///< empty: results name it by its bodies
    bool operator==(const JointData&) const = default;
};

/// What acts on bodies besides gravity; mechanics/forces/ has the equations. Points (m) and the axis in space
/// coordinates of the initial configuration. Springs: stiffness (N/m or N m/rad), damping (N s/m or N m s/rad), free
/// length (m, by default the initial one) or angle (rad, by default 0), full turns of a torsion spring at the start.
/// Loads: force (N) at a point (by default the mass centre), or torque (N m), times 1 + amplitude sin(frequency t).
struct ForceData {
    std::string type = "spring";              ///< the name of a force (mechanics/parts/forces/)
    std::array<std::string, 2> between = {};  ///< a load acts on the second
    std::array<Vector3, 2> points = {};
    Vector3 axis = {0, 0, 1};
    double stiffness = 0, damping = 0;
    std::optional<double> rest = {};  ///< free length or angle
    long turns = 0;
    std::vector<double> coefficients = {};  ///< of a polynomial law, from the linear one on
    Matrix3 axes = identity3;               ///< of a bushing: columns, space coordinates of the initial configuration
    std::array<Vector3, 2> stiffnesses = {}, dampings = {};  ///< along these axes and about them
    double attraction = 0;  ///< gravitational constant, m^3/(kg s^2), or that times the mass at a centre, m^3/s^2
    Vector3 value = {0, 0, 0};
    std::optional<Vector3> point = {};  ///< where a force acts, or the centre of a field
    bool body_axes = false;             ///< whether the value turns with the body
    double amplitude = 0, frequency = 0;
    bool operator==(const ForceData&) const = default;
};

using ParameterValue =
    std::variant<double, Vector3, Matrix3, std::vector<BodyData>, bool, std::vector<JointData>, std::vector<ForceData>>;
using ParameterValues = std::map<std::string, ParameterValue>;

/// A parameter that does not describe a system. `path` is a JSON pointer below the parameters, such as "/inertia/2".
/// Where it is an unknown name, `written` is that name and `known` are the valid ones.
struct ParameterError : std::invalid_argument {
    std::string path;
    std::string written;
    std::vector<std::string> known;
    ParameterError(std::string where, const std::string& what, std::string name = {},
                   std::vector<std::string> names = {})
        : std::invalid_argument(what), path(std::move(where)), written(std::move(name)), known(std::move(names)) {}
};

}  // namespace kreisel
