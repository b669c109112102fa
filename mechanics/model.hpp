// SPDX-License-Identifier: BSD-3-Clause
//
// A mechanical model: rigid bodies, spherical joints, gravity and loads, with the initial state. SI units.
#pragma once

#include <string>
#include <vector>

#include "lie/linear.hpp"
#include "mechanics/data.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Pose and velocity of a body: x, v of the mass centre in space axes, omega in body axes, R body to space.
struct BodyState {
    Vec3 x = Vec3::Zero();
    Mat3 R = Mat3::Identity();
    Vec3 v = Vec3::Zero();
    Vec3 omega = Vec3::Zero();
};

/// Rigid body; J is the inertia about the mass centre in body axes.
struct Body {
    std::string name;
    Real mass = 1;
    Mat3 J = Mat3::Identity();
    BodyState start;
};

/// Inertia about a point, J + m (|c|^2 I - c c^T), with c from the point to the mass centre.
inline Mat3 inertia_about(const Body& body, const Vec3& c) {
    return body.J + body.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
}

inline constexpr int ground = -1;

/// Spherical joint: Phi = (point of first) - (point of second) = 0, three rows in space axes. A point is given in the
/// body axes of its body, from the mass centre; for `ground` in space coordinates. The second is never the ground.
struct SphericalJoint {
    int first = ground, second = 0;
    Vec3 r_first = Vec3::Zero(), r_second = Vec3::Zero();
};

/// g(t) = g (1 + amplitude sin(frequency t)); frequency in rad/s.
struct Gravity {
    Vec3 g = Vec3::Zero();
    Real amplitude = 0, frequency = 0;
    bool is_constant() const { return amplitude == 0; }
    Vec3 at(const Real& t) const { return is_constant() ? g : Vec3(g * (1 + amplitude * sin(frequency * t))); }
};

/// A force (N) through the mass centre of a body and a torque (N m), both times 1 + amplitude sin(frequency t), given in
/// space axes or in axes that turn with the body; frequency in rad/s.
struct Load {
    enum class Axes { space, body };
    struct Wrench {
        Vec3 force, torque;
    };
    int body = 0;
    Axes axes = Axes::space;
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    Real amplitude = 0, frequency = 0;
    /// At time t in body axes; R is the body's rotation.
    Wrench in_body_axes(const Real& t, const Eigen::Map<const Mat3>& R) const {
        const Real factor = 1 + amplitude * sin(frequency * t);
        if (axes == Axes::body) return {factor * force, factor * torque};
        return {factor * (R.transpose() * force), factor * (R.transpose() * torque)};
    }
};

struct Model {
    std::vector<Body> bodies;
    std::vector<SphericalJoint> joints;
    Gravity gravity;
    std::vector<Load> loads;
    std::vector<std::string> warnings;

    /// Joint whose two points coincide at `point` (space coordinates) in the initial configuration.
    void join(int first, int second, const Vec3& point);
};

/// What an inertia must satisfy beyond being positive definite. The triangle inequality J1 + J2 >= J3 of the principal
/// moments (relative slack 1e-12; equality is a flat body) holds for every mass distribution; published test data
/// sometimes violate it, so a problem may ask for a warning only.
enum class TriangleInequality { required, warned };

Vec3 to_vec3(const Vector3& v);
/// Reads a rotation; one that is orthonormal to 1e-9 is orthonormalised to the last bit of Real.
/// Throws ParameterError at `path`.
Mat3 to_rotation(const Matrix3& R, const std::string& path);
/// Checks symmetry, definiteness and the triangle inequality. Throws ParameterError at `path`.
Mat3 to_inertia(const Matrix3& J, const std::string& path, TriangleInequality, std::vector<std::string>& warnings);
/// Checks a body's name: letters, digits, `_` and `-`, and not "ground". Throws ParameterError at `path`.
const std::string& to_name(const std::string& name, const std::string& path);
/// Checks that a mass is positive. Throws ParameterError at `path`.
Real to_mass(double mass, const std::string& path);

/// Velocities of the bodies not marked in `given`, from the joints: least norm among those that satisfy them.
void complete_velocities(Model& model, const std::vector<bool>& given);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
