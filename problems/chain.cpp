// SPDX-License-Identifier: BSD-3-Clause
//
// A chain of N equal rods on spherical joints, the first of them on the ground at the origin. It starts straight along
// x, rotating rigidly, then falls. The data are our own.
#include "problems/shapes.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model chain(const Parameters& p) {
    Model model;
    const Real length = p.scalar("length"), width = p.scalar("width"), mass = p.mass("mass");
    const Vec3 omega = p.vector("omega");
    for (int i = 0; i < p.count("links"); ++i) {
        const Vec3 x = (Real(i) + Real(1) / 2) * length * Vec3::UnitX();
        model.bodies.push_back({.name = "link" + std::to_string(i + 1),
                                .mass = mass,
                                .J = box_inertia(mass, length, width, width),
                                .start = turning(x, Mat3::Identity(), Vec3::Zero(), omega)});
        model.join(i == 0 ? ground : i - 1, i, Real(i) * length * Vec3::UnitX());
    }
    model.gravity.g = p.vector("gravity");
    return model;
}

}  // namespace

KREISEL_PROBLEM(chain, {.name = "chain",
                        .summary = "chain of N rods on spherical joints; the cost per step is linear in N",
                        .cites = {},
                        .parameters = {{"links", ParameterKind::count, "1", "number of rods", 5.0},
                                       {"mass", ParameterKind::positive, "kg", "mass of a rod", 0.5},
                                       {"length", ParameterKind::positive, "m", "length of a rod", 0.4},
                                       {"width", ParameterKind::positive, "m", "side of its square section", 0.1},
                                       {"omega", ParameterKind::vector, "rad/s", "initial turning of the chain",
                                        Vector3{1, 0.5, 2}},
                                       gravity_parameter({0, 0, -9.81})}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
