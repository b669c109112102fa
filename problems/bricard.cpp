// SPDX-License-Identifier: BSD-3-Clause
//
// Bricard's mechanism, problem A04 of the library of IFToMM [gonzalez2006]: five rods of 1 m and 1 kg, section 0.1 x
// 0.1 m, between six hinges at (0,0,0), (1,0,0), (1,-1,0), (1,-1,1), (0,-1,1), (0,0,1), whose axes are along y, z, x,
// y, z, x. By counting rows it would be rigid, but one of the 30 is redundant. Released at rest, gravity along -y.
#include "problems/shapes.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model bricard(const Parameters& p) {
    const Vec3 hinges[] = {{0, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, -1, 1}, {0, -1, 1}, {0, 0, 1}};
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const Vec3 axes[] = {y, z, x, y, z, x};
    const Real width = decimal(0.1);
    Model model;
    for (int i = 0; i < 5; ++i) {
        const Vec3 along = hinges[i + 1] - hinges[i];
        model.bodies.push_back({.name = "rod" + std::to_string(i + 1),
                                .mass = 1,
                                .J = box_inertia(1, 1, width, width),
                                .start = {.x = (hinges[i] + hinges[i + 1]) / 2, .R = axes_along(along, axes[i])}});
    }
    for (int i = 0; i < 6; ++i)
        model.join(i == 0 ? ground : i - 1, i == 5 ? ground : i, hinges[i], "revolute", axes[i]);
    model.gravity.g = p.vector("gravity");
    return model;
}

}  // namespace

KREISEL_PROBLEM(bricard,
                {.name = "bricard",
                 .summary = "Bricard's mechanism (IFToMM A04): six hinges in a loop, one redundant row, one freedom",
                 .cites = {"gonzalez2006"},
                 .parameters = {gravity_parameter({0, -9.81, 0})}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
