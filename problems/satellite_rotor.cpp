// SPDX-License-Identifier: BSD-3-Clause
//
// A satellite with a spinning rotor on a hinge along a principal axis through the common mass centre, without gravity:
// a gyrostat. Energy, linear and angular momentum and the momentum of the rotor along its axis are constant. The data
// are our own.
#include "problems/shapes.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model satellite(const Parameters& p) {
    Model model;
    const Vec3 omega = p.vector("omega"), v = p.vector("v");
    Body hull{.name = "hull", .mass = p.mass("mass")};
    hull.J = p.inertia("inertia", TriangleInequality::required, model.warnings);
    hull.start.omega = omega, hull.start.v = v;
    Body rotor{.name = "rotor", .mass = p.mass("rotor_mass")};
    rotor.J = p.inertia("rotor_inertia", TriangleInequality::required, model.warnings);
    rotor.start.omega = omega + p.scalar("spin") * Vec3::UnitZ(), rotor.start.v = v;
    model.bodies = {hull, rotor};
    model.join(0, 1, Vec3::Zero(), "revolute", Vec3::UnitZ());
    return model;
}

}  // namespace

KREISEL_PROBLEM(
    satellite,
    {.name = "satellite_rotor",
     .summary = "free satellite with a spinning rotor (gyrostat)",
     .cites = {},
     .parameters = {
         {"mass", ParameterKind::positive, "kg", "mass of the hull", 100.0},
         {"inertia", ParameterKind::inertia, "kg m^2", "of the hull", diagonal(40, 60, 50)},
         {"omega", ParameterKind::vector, "rad/s", "initial angular velocity of the hull", Vector3{0.3, 0.1, 0.2}},
         {"v", ParameterKind::vector, "m/s", "initial velocity, space axes", Vector3{0.1, -0.2, 0.05}},
         {"rotor_mass", ParameterKind::positive, "kg", "mass of the rotor", 10.0},
         {"rotor_inertia", ParameterKind::inertia, "kg m^2", "of the rotor, which turns about z",
          diagonal(0.6, 0.6, 1)},
         {"spin", ParameterKind::scalar, "rad/s", "initial spin of the rotor relative to the hull", 20.0}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
