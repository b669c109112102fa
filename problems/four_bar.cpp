// SPDX-License-Identifier: BSD-3-Clause
//
// The four-bar mechanism with N windows, problem A02 of the library of IFToMM [gonzalez2006]: N + 1 cranks at (0, 0,
// 0), (1, 0, 0), ..., N coupling bars between their tips, all of 1 kg and 1 m, on hinges along z; it starts upright,
// the tips moving along x at 1 m/s. It passes through positions in which all bars lie in a line and the constraints
// lose rank. In space each window also has three redundant rows. Section 0.1 m: only the moment about z counts, which
// is that of a thin rod.
#include "problems/shapes.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model four_bar(const Parameters& p) {
    const int windows = p.count("windows");
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const Mat3 thin = moments(0.01, 0.08, 0) + Mat3(Vec3(0, 0, Real(1) / 12).asDiagonal());
    const Mat3 upright = axes_along(y, z);  // a bar lies along its x axis
    const Real speed = p.scalar("speed");
    Model model;
    const auto add = [&](const std::string& name, int number, const BodyState& start) {
        model.bodies.push_back({.name = name + std::to_string(number), .mass = 1, .J = thin, .start = start});
        return static_cast<int>(model.bodies.size()) - 1;
    };
    for (int i = 0; i <= windows; ++i) {
        const Vec3 foot = Real(i) * x;
        const int crank = add("crank", i + 1, turning(foot + y / 2, upright, foot, -speed * z));
        model.join(ground, crank, foot, "revolute", z);
    }
    for (int i = 0; i < windows; ++i) {
        const Vec3 left = Real(i) * x + y;
        const int bar = add("bar", i + 1, {.x = left + x / 2, .v = speed * x});
        model.join(i, bar, left, "revolute", z);
        model.join(bar, i + 1, left + x, "revolute", z);
    }
    model.gravity.g = p.vector("gravity");
    return model;
}

}  // namespace

KREISEL_PROBLEM(four_bar,
                {.name = "four_bar",
                 .summary = "four-bar mechanism with N windows (IFToMM A02): redundant rows, singular positions",
                 .cites = {"gonzalez2006"},
                 .parameters = {{"windows", ParameterKind::count, "1", "number of windows N", 2.0},
                                {"speed", ParameterKind::scalar, "m/s", "initial speed of the tips, along x", 1.0},
                                gravity_parameter({0, -9.81, 0})}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
