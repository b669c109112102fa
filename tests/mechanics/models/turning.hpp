// SPDX-License-Identifier: BSD-3-Clause
//
// Torsion springs that wind up by several turns, with their angles in closed form.
#pragma once

#include "tests/mechanics/models/linked.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace models {

/// theta'' = -k/J (theta - rest) - c/J theta', underdamped.
struct Oscillation {
    Real J, k, c, rest, theta, rate;  ///< theta and rate at t = 0
    /// theta and theta' at time t.
    std::pair<Real, Real> operator()(const Real& t) const {
        using std::exp;
        const Real d = c / (2 * J), w = sqrt(k / J - d * d), a = theta - rest, b = (rate + d * a) / w;
        const Real decay = exp(-d * t), cosine = cos(w * t), sine = sin(w * t);
        return {rest + decay * (a * cosine + b * sine), decay * ((b * w - d * a) * cosine - (a * w + d * b) * sine)};
    }
};

/// A spring about the axis of rotation of bodies, its exact motion, and the map from its angle to omega of the body.
struct Turner {
    std::string name;
    Model model;
    Oscillation exact;
    int body = 0;  ///< that the spring acts on as the second; the first is the ground, or body 0
    Vec3 axis = Vec3::UnitZ();

    /// theta' from the bodies: the relative angular velocity along the axis, in space axes.
    Real rate(const std::vector<BodyState>& bodies) const {
        const auto spin = [&](int i) {
            return Vec3(bodies.at(static_cast<std::size_t>(i)).R * bodies.at(static_cast<std::size_t>(i)).omega);
        };
        const Vec3 e = axis.normalized();
        return e.dot(spin(body)) - (body == 0 ? Real(0) : e.dot(spin(0)));
    }
};

/// A wheel on a joint at the origin, J = 1: of type `revolute`, or `spherical` for SO3.
inline Turner wheel(JointType type, const Real& rate, const Real& rest = 0, long turns = 0) {
    Turner turner{"wheel", {}, {1, 4, 0, rest, 2 * pi() * Real(turns), rate}};
    Body body{.name = "wheel"};
    body.start.omega = Vec3(0, 0, rate);
    turner.model.bodies = {body};
    turner.model.join(ground, 0, Vec3::Zero(), type);
    turner.model.torsion_springs = {{.first = ground, .second = 0, .stiffness = 4, .angle = rest, .turns = turns}};
    return turner;
}

/// A body without symmetry on a hinge through a point off its mass centre, about an axis that no axis is near, with
/// damping. The frames of the spring differ by `phase`, and so does its angle at the start.
inline Turner crooked(const Real& rate, const Real& phase) {
    Turner turner{"crooked", bodies_in_a_row(1), {}, 0, Vec3(1, -2, 4)};
    Body& body = turner.model.bodies[0];
    const Vec3 e = turner.axis.normalized(), point(Real(1) / 2, -1, Real(1) / 4);
    body.start.omega = rate * (body.start.R.transpose() * e);
    turner.model.join(ground, 0, point, "revolute", e);
    complete_velocities(turner.model, {false});
    const Vec3 mine = body.start.R.transpose() * e;
    const Real J = mine.dot(inertia_about(body, body.start.R.transpose() * (body.start.x - point)) * mine);
    TorsionSpring spring{
        .first = ground, .second = 0, .axes_first = axes_about(e), .stiffness = 3 * J, .damping = J / 4, .angle = -2};
    spring.axes_second = turner.model.axes_of(0, SO3::exp(phase * e) * axes_about(e));
    turner.model.torsion_springs = {spring};
    turner.exact = {J, 3 * J, J / 4, -2, phase, rate};
    return turner;
}

/// Two bodies without symmetry on one axis, the first hinged to the ground and the second to the first.
inline Turner moving_pair(const Real& rate) {
    Turner turner{"moving pair", bodies_in_a_row(2), {}, 1, Vec3(2, 1, 2)};
    Model& model = turner.model;
    const Vec3 e = turner.axis.normalized(), point(1, 1, 0);
    Real J[2];
    for (int i = 0; i < 2; ++i) {
        Body& body = model.bodies[static_cast<std::size_t>(i)];
        const Vec3 mine = body.start.R.transpose() * e;
        body.start.omega = (i == 0 ? -rate / 3 : 2 * rate / 3) * mine;
        model.join(i - 1, i, point, "revolute", e);
        J[i] = mine.dot(inertia_about(body, body.start.R.transpose() * (body.start.x - point)) * mine);
    }
    complete_velocities(model, {false, false});
    const Real reduced = J[0] * J[1] / (J[0] + J[1]);
    TorsionSpring spring{.first = 0, .second = 1, .stiffness = 5 * reduced, .damping = reduced / 8, .angle = 7};
    spring.axes_first = model.axes_of(0, axes_about(e)), spring.axes_second = model.axes_of(1, axes_about(e));
    model.torsion_springs = {spring};
    turner.exact = {reduced, 5 * reduced, reduced / 8, 7, 0, rate};
    return turner;
}

}  // namespace models
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
