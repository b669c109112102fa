// SPDX-License-Identifier: BSD-3-Clause
//
// First integrals found from the structure of a model. Each is declared only where its reason holds.
#include <Eigen/Eigenvalues>
#include <optional>

#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using States = std::span<const BodyState>;
constexpr const char* axis_names[] = {"x", "y", "z"};

Real energy(const Model& model, States states) {
    Real sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Body& body = model.bodies[i];
        const BodyState& s = states[i];
        sum += body.mass * s.v.squaredNorm() / 2 + s.omega.dot(body.J * s.omega) / 2;
        sum -= body.mass * model.gravity.g.dot(s.x);
    }
    return sum;
}

/// sum (x - P) x m v + R J omega.
Vec3 angular_momentum(const Model& model, const Vec3& P, States states) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Body& body = model.bodies[i];
        const BodyState& s = states[i];
        sum += (s.x - P).cross(body.mass * s.v) + s.R * (body.J * s.omega);
    }
    return sum;
}

Vec3 linear_momentum(const Model& model, States states) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < states.size(); ++i) sum += model.bodies[i].mass * states[i].v;
    return sum;
}

/// Sizes of the terms of the quantities above.
Real energy_size(const Model& model, States states) {
    Real sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Body& body = model.bodies[i];
        const BodyState& s = states[i];
        sum += body.mass * s.v.squaredNorm() / 2 + s.omega.dot(body.J * s.omega) / 2;
        sum += body.mass * model.gravity.g.norm() * s.x.norm();
    }
    return sum;
}

Real angular_momentum_size(const Model& model, const Vec3& P, States states) {
    Real sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i)
        sum += (states[i].x - P).norm() * model.bodies[i].mass * states[i].v.norm() +
               (model.bodies[i].J * states[i].omega).norm();
    return sum;
}

Real linear_momentum_size(const Model& model, States states) {
    Real sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i) sum += model.bodies[i].mass * states[i].v.norm();
    return sum;
}

/// The ground point that all joints to the ground share; the origin if there is none; nothing if they differ.
std::optional<Vec3> common_pivot(const Model& model) {
    std::optional<Vec3> pivot;
    for (const SphericalJoint& joint : model.joints) {
        if (joint.first != ground) continue;
        if (pivot && *pivot != joint.r_first) return std::nullopt;
        pivot = joint.r_first;
    }
    return pivot ? pivot : Vec3(Vec3::Zero());
}

bool touches_ground(const Model& model) {
    for (const SphericalJoint& joint : model.joints)
        if (joint.first == ground) return true;
    return false;
}

/// Unit axis e such that J = a e e^T + b (I - e e^T) to working precision, or nothing.
std::optional<Vec3> symmetry_axis(const Mat3& J) {
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(J);
    const Vec3 moments = principal.eigenvalues();
    const Real slack = 16 * epsilon * moments[2];
    if (moments[1] - moments[0] <= slack) return Vec3(principal.eigenvectors().col(2));
    if (moments[2] - moments[1] <= slack) return Vec3(principal.eigenvectors().col(0));
    return std::nullopt;
}

void add_momenta(const Model& model, std::vector<FirstIntegral>& integrals) {
    const auto pivot = common_pivot(model);
    const Vec3 g = model.gravity.g;
    if (!pivot) return;
    if (!g.isZero(0)) {
        const Vec3 up = -g / g.norm();
        integrals.push_back({"angular_momentum_vertical", "N m s",
                             "gravity has no moment about the vertical through the common fixed point of the joints",
                             [model, P = *pivot, up](States s) { return up.dot(angular_momentum(model, P, s)); },
                             [model, P = *pivot](States s) { return angular_momentum_size(model, P, s); }});
        return;
    }
    for (int k = 0; k < 3; ++k)
        integrals.push_back({std::string("angular_momentum_") + axis_names[k], "N m s",
                             "no external moment acts about the reference point",
                             [model, P = *pivot, k](States s) { return angular_momentum(model, P, s)[k]; },
                             [model, P = *pivot](States s) { return angular_momentum_size(model, P, s); }});
    if (touches_ground(model)) return;
    for (int k = 0; k < 3; ++k)
        integrals.push_back({std::string("momentum_") + axis_names[k], "N s", "no external force acts",
                             [model, k](States s) { return linear_momentum(model, s)[k]; },
                             [model](States s) { return linear_momentum_size(model, s); }});
}

/// omega along the symmetry axis of a body whose external moment has no component along it.
void add_body_momenta(const Model& model, std::vector<FirstIntegral>& integrals) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const Body& body = model.bodies[i];
        const SphericalJoint* only = nullptr;
        int joints = 0;
        for (const SphericalJoint& joint : model.joints)
            if (joint.first == static_cast<int>(i) || joint.second == static_cast<int>(i)) only = &joint, ++joints;
        if (joints > 1 || (only && only->first != ground)) continue;
        const Vec3 lever = only ? Vec3(-only->r_second) : Vec3(Vec3::Zero());
        const Mat3 J_O = inertia_about(body, lever);
        const auto axis = symmetry_axis(J_O);
        if (!axis || axis->cross(lever).norm() > 16 * epsilon * lever.norm()) continue;
        const Vec3 e = *axis * (axis->sum() < 0 ? -1 : 1);
        const std::string suffix = model.bodies.size() > 1 ? "_" + body.name : "";
        integrals.push_back({"body_momentum" + suffix, "N m s",
                             "the body is symmetric about an axis along which no moment acts",
                             [J = body.J, e, i](States s) { return e.dot(J * s[i].omega); },
                             [J = body.J, i](States s) { return Real((J * s[i].omega).norm()); }});
    }
}

}  // namespace

std::vector<FirstIntegral> first_integrals(const Model& model) {
    std::vector<FirstIntegral> integrals;
    if (!model.loads.empty()) return integrals;  // a load does work, and has a moment about every axis
    if (model.gravity.is_constant())
        integrals.push_back({"energy", "J",
                             model.joints.empty() ? "no force but constant gravity acts"
                                                  : "gravity is constant and the joints do no work",
                             [model](States states) { return energy(model, states); },
                             [model](States states) { return energy_size(model, states); }});
    add_momenta(model, integrals);
    add_body_momenta(model, integrals);
    return integrals;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
