// SPDX-License-Identifier: BSD-3-Clause
//
// The N-fold spherical pendulum: N point masses of 1 kg on massless rods of length 5/N m, released at rest along x, as
// in [celledoni2022, Sec. 4.3], where N = 2, ..., 20 and the end is at 3 s. The rods are distance joints.
#include "problems/shapes.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model pendulum_chain(const Parameters& p) {
    Model model;
    const int N = p.count("masses");
    const Real length = p.scalar("length") / N, mass = p.mass("mass");
    for (int i = 0; i < N; ++i) {
        model.bodies.push_back({.name = "mass" + std::to_string(i + 1),
                                .mass = mass,
                                .start = {.x = Real(i + 1) * length * Vec3::UnitX()},
                                .point = true});
        model.joints.push_back({.first = i == 0 ? ground : i - 1, .second = i, .type = "distance", .length = length});
    }
    model.gravity.g = p.vector("gravity");
    return model;
}

}  // namespace

KREISEL_PROBLEM(pendulum_chain,
                {.name = "spherical_pendulum_chain",
                 .summary = "the literature's N-fold spherical pendulum of point masses on massless rods",
                 .cites = {"celledoni2022"},
                 .parameters = {{"masses", ParameterKind::count, "1", "number of point masses N", 3.0},
                                {"mass", ParameterKind::positive, "kg", "mass of each", 1.0},
                                {"length", ParameterKind::positive, "m", "of all rods together", 5.0},
                                gravity_parameter({0, 0, -9.81})}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
