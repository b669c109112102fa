// SPDX-License-Identifier: BSD-3-Clause
//
// Two equal rods on parallel hinges along y, which keep the motion in a plane: 10 constraints in space for a system
// with two degrees of freedom. Released at rest, horizontal and bent. The data are our own.
#include "problems/shapes.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model pendulum(const Parameters& p) {
    Model model;
    const Real length = p.scalar("length"), mass = p.mass("mass");
    const Mat3 J = box_inertia(mass, length, length / 10, length / 10);
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const Vec3 bend = (3 * x + 4 * z) / 5;
    Mat3 tilted;
    tilted << bend, y, bend.cross(y);
    model.bodies.push_back({.name = "upper", .mass = mass, .J = J, .start = {.x = length / 2 * x}});
    model.bodies.push_back(
        {.name = "lower", .mass = mass, .J = J, .start = {.x = length * x + length / 2 * bend, .R = tilted}});
    model.join(ground, 0, Vec3::Zero(), "revolute", y);
    model.join(0, 1, length * x, "revolute", y);
    model.gravity.g = p.vector("gravity");
    return model;
}

}  // namespace

KREISEL_PROBLEM(pendulum, {.name = "planar_double_pendulum",
                           .summary = "two rods on parallel hinges: planar motion by constraints in space",
                           .cites = {},
                           .parameters = {{"mass", ParameterKind::positive, "kg", "mass of each rod", 1.0},
                                          {"length", ParameterKind::positive, "m", "length of each rod", 1.0},
                                          gravity_parameter({0, 0, -9.81})}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
