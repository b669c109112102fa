// SPDX-License-Identifier: BSD-3-Clause
//
// The acceptance problem without constraints: an asymmetric free body under a torque fixed in space and a force fixed
// in the body, each times 1 + A sin(W t). The torque in body axes depends on the rotation, so the field is state
// dependent, non-commuting and non-autonomous, and the force carries errors of the rotation into the position. Nothing
// is conserved. The data are our own; with force and initial velocity zero the body also has the formulation SO3.
#include "problems/problem.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model forced_free_body(const Parameters& p) {
    Model model;
    Body body{.name = "body", .mass = p.mass("mass")};
    body.J = p.inertia("inertia", TriangleInequality::required, model.warnings);
    body.start = {Vec3::Zero(), p.rotation("R"), p.vector("v"), p.vector("omega")};
    model.bodies.push_back(body);
    model.loads.push_back({.axes = Load::Axes::space,
                           .torque = p.vector("torque"),
                           .amplitude = p.scalar("torque_amplitude"),
                           .frequency = p.scalar("torque_frequency")});
    model.loads.push_back({.axes = Load::Axes::body,
                           .force = p.vector("force"),
                           .amplitude = p.scalar("force_amplitude"),
                           .frequency = p.scalar("force_frequency")});
    return model;
}

}  // namespace

KREISEL_PROBLEM(
    forced_free_body,
    {.name = "forced_free_body",
     .summary = "asymmetric free body under a modulated torque and force: the acceptance problem without constraints",
     .cites = {},
     .parameters = {
         {"mass", ParameterKind::positive, "kg", "mass", 2.0},
         {"inertia", ParameterKind::inertia, "kg m^2", "inertia about the mass centre, body axes",
          Matrix3{0.3, 0.05, -0.02, 0.05, 0.5, 0.03, -0.02, 0.03, 0.4}},
         {"omega", ParameterKind::vector, "rad/s", "initial angular velocity, body axes", Vector3{0.5, 3, -0.4}},
         {"R", ParameterKind::rotation, "1", "initial rotation, body to space", identity3},
         {"v", ParameterKind::vector, "m/s", "initial velocity, space axes", Vector3{0.3, -0.2, 0.5}},
         {"torque", ParameterKind::vector, "N m", "torque, space axes", Vector3{1.5, -0.8, 1.2}},
         {"torque_amplitude", ParameterKind::scalar, "1", "A in torque (1 + A sin(W t))", 0.5},
         {"torque_frequency", ParameterKind::scalar, "rad/s", "W in torque (1 + A sin(W t))", 5.0},
         {"force", ParameterKind::vector, "N", "force through the mass centre, body axes", Vector3{4, 7, -5}},
         {"force_amplitude", ParameterKind::scalar, "1", "A in force (1 + A sin(W t))", 0.5},
         {"force_frequency", ParameterKind::scalar, "rad/s", "W in force (1 + A sin(W t))", 4.0}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
