// SPDX-License-Identifier: BSD-3-Clause
//
// A rigid body on which nothing acts (Euler's top). Default: inertia (2, 1, 2/3) and body angular momentum
// (cos 1.1, 0, sin 1.1), the data of [hairer2006, Fig. IV.1.1]; that inertia violates the triangle inequality
// (2 > 1 + 2/3), so no real body has it; this gives a warning and does not affect the equations.
#include "mechanics/free_body/free_rotation.hpp"
#include "problems/problem.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model free_top(const Parameters& p) {
    Model model;
    Body body{.name = "top", .mass = p.mass("mass")};
    body.J = p.inertia("inertia", TriangleInequality::warned, model.warnings);
    body.start = {Vec3::Zero(), p.rotation("R"), p.vector("v"), p.vector("omega")};
    model.bodies.push_back(body);
    return model;
}

/// x = v t and the closed form of the rotation.
std::vector<BodyState> exact(const Parameters& p, const Real& t) {
    const Model model = free_top(p);
    const Body& body = model.bodies[0];
    const FreeRotation rotation = free_rotation(body.J, body.start.R, body.start.omega, t);
    return {{body.start.x + body.start.v * t, rotation.R, body.start.v, rotation.omega}};
}

}  // namespace

// omega = J^{-1} m with m = (cos 1.1, 0, sin 1.1), to 16 digits.
KREISEL_PROBLEM(free_top,
                {.name = "free_top",
                 .summary = "free rigid body (Euler's top), with a closed form",
                 .cites = {"hairer2006", "celledonifasso2008"},
                 .parameters = {{"mass", ParameterKind::positive, "kg", "mass", 1.0},
                                {"inertia", ParameterKind::inertia, "kg m^2",
                                 "inertia about the mass centre, body axes", diagonal(2, 1, 0.6666666666666667)},
                                {"omega", ParameterKind::vector, "rad/s", "initial angular velocity, body axes",
                                 Vector3{0.2267980607127887, 0, 1.336811040092153}},
                                {"R", ParameterKind::rotation, "1", "initial rotation, body to space", identity3},
                                {"v", ParameterKind::vector, "m/s", "initial velocity, space axes", Vector3{0, 0, 0}}}},
                exact);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
