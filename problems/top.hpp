// SPDX-License-Identifier: BSD-3-Clause
//
// A rigid body on a spherical joint at the origin: shared by the heavy tops.
#pragma once

#include "problems/problem.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// x = R lever, v = R (omega x lever).
inline Model top(const Parameters& p) {
    Model model;
    Body body{.name = "top", .mass = p.mass("mass")};
    body.J = p.inertia("inertia", TriangleInequality::required, model.warnings);
    const Vec3 lever = p.vector("lever");
    const Mat3 R = p.rotation("R");
    const Vec3 omega = p.vector("omega");
    body.start = {R * lever, R, R * omega.cross(lever), omega};
    model.bodies.push_back(body);
    model.joints.push_back({ground, 0, Vec3::Zero(), -lever});
    model.gravity.g = p.vector("gravity");
    return model;
}

/// The parameters all tops share, with the given defaults.
inline std::vector<ParameterDescription> top_parameters(double mass, const Matrix3& inertia, const Vector3& lever,
                                                        const Vector3& omega) {
    return {{"mass", ParameterKind::positive, "kg", "mass", mass},
            {"inertia", ParameterKind::inertia, "kg m^2", "inertia about the mass centre, body axes", inertia},
            {"lever", ParameterKind::vector, "m", "pivot to mass centre, body axes", lever},
            {"gravity", ParameterKind::vector, "m/s^2", "gravity, space axes", Vector3{0, 0, -9.81}},
            {"omega", ParameterKind::vector, "rad/s", "initial angular velocity, body axes", omega},
            {"R", ParameterKind::rotation, "1", "initial rotation, body to space", identity3}};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
