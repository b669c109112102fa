// SPDX-License-Identifier: BSD-3-Clause
//
// A mechanical model: rigid bodies, joints, gravity and forces, with the initial state. SI units.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "lie/linear.hpp"
#include "mechanics/forces/forces.hpp"
#include "mechanics/model/data.hpp"
#include "mechanics/model/motion.hpp"
#include "mechanics/model/prescribed.hpp"
#include "mechanics/parts/joint_type.hpp"

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
    bool point = false;  ///< a point mass: J is the identity and no moment acts, so its rotation is constant
};

/// Inertia about a point, J + m (|c|^2 I - c c^T), with c from the point to the mass centre.
inline Mat3 inertia_about(const Body& body, const Vec3& c) {
    return body.J + body.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
}

/// 1/m; NaN for an infinite mass: treating 1/m as 0 would silently fix the body.
inline Real inverse_mass(const Body& body) {
    return isfinite(body.mass) ? Real(1 / body.mass) : std::numeric_limits<Real>::quiet_NaN();
}

/// A joint between two bodies, either of which may be `ground`, but not both. Its rows and their signs are those of
/// mechanics/joints/joint_rows.hpp: Phi = (what the first body has) - (what the second has). Points are in the body
/// axes of their body, from the mass centre; for `ground` in space coordinates. So are the axes, the columns of a
/// rotation: the third is the axis of the joint (of a universal joint, one for each body).
struct Joint {
    int first = ground, second = 0;
    Vec3 r_first = Vec3::Zero(), r_second = Vec3::Zero();
    JointType type = "spherical";
    Mat3 axes_first = Mat3::Identity(), axes_second = Mat3::Identity();
    Real length = 0;                    ///< of a distance joint; of a rolling joint the radius (m)
    Real amplitude = 0, frequency = 0;  ///< of a distance joint: length (1 + amplitude sin(frequency t)), rad/s
    Prescribed turn = {}, shift = {};   ///< of the rows of these names: rad, m
    Real lead = 0;                      ///< of a screw or a rack: its shift in one turn (m)
    std::array<int, 2> teeth = {0, 0};  ///< of a gear
    std::string name = {};              ///< empty: that of its bodies
};

/// g(t) = g (1 + amplitude sin(frequency t)); frequency in rad/s.
struct Gravity {
    Vec3 g = Vec3::Zero();
    Real amplitude = 0, frequency = 0;
    bool is_constant() const { return amplitude == 0; }
    Vec3 at(const Real& t) const { return is_constant() ? g : Vec3(g * (1 + amplitude * sin(frequency * t))); }
};

/// Its forces besides gravity are in lists of its base: loads, springs, torsion_springs (mechanics/forces/forces.hpp).
struct Model : Forces {
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    Gravity gravity;
    std::vector<std::string> warnings;

    /// A point and axes in space coordinates of the initial configuration, attached to a body (or the ground).
    Vec3 point_of(int body, const Vec3& point) const;
    Mat3 axes_of(int body, const Mat3& axes) const;
    /// Joint at a point, about an axis of any length (space coordinates of the initial configuration), the same for
    /// both bodies. Not for universal joints, which have two axes, nor for distance joints, which have two points.
    void join(int first, int second, const Vec3& point, JointType type = "spherical", const Vec3& axis = Vec3::UnitZ());
    std::string name_of(int body) const;
    /// "joint 2 (crank - rod, revolute)".
    std::string name_of_joint(std::size_t joint) const;
    /// The names of the joints in results, all different: a joint's own name, or "crank-rod"; where that is taken,
    /// "crank-rod-2".
    std::vector<std::string> joint_names() const;
    /// "torsion spring 0 (ground - wheel)", counting torsion springs only.
    std::string name_of_torsion_spring(std::size_t spring) const;
};

/// A rotation whose third column is the direction of `axis`, which is not zero.
Mat3 axes_about(const Vec3& axis);

/// What an inertia must satisfy besides being positive definite. The triangle inequality J1 + J2 >= J3 of the principal
/// moments (relative slack 1e-12; equality is a flat body) holds for every mass distribution; published test data
/// sometimes violate it, so a problem may reduce this to a warning.
enum class TriangleInequality { required, warned };

Vec3 to_vec3(const Vector3& v);
/// Reads a rotation; one orthonormal to 1e-9 is orthonormalised to the precision of Real.
/// Throws ParameterError at `path`.
Mat3 to_rotation(const Matrix3& R, const std::string& path);
/// Checks symmetry, definiteness and the triangle inequality. Throws ParameterError at `path`.
Mat3 to_inertia(const Matrix3& J, const std::string& path, TriangleInequality, std::vector<std::string>& warnings);
/// Checks a body's name: letters, digits, `_` and `-`, and not "ground". Throws ParameterError at `path`.
const std::string& to_name(const std::string& name, const std::string& path);
/// Checks that a mass is positive. Throws ParameterError at `path`.
Real to_mass(double mass, const std::string& path);

/// Which bodies have their own v, and their own omega.
struct GivenVelocities {
    std::vector<bool> v, omega;
};

/// Velocities that are not given, from the joints: among those with C v + b = 0, the ones of least kinetic energy.
/// Where only v are asked for, of least norm, which is the same where they are unique. A warning says what was free in
/// a motion that is not rest. What is given may contradict the joints: check_start tells.
void complete_velocities(Model& model, const GivenVelocities& given);
/// With all omega given.
void complete_velocities(Model& model, const std::vector<bool>& given_v);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
