// SPDX-License-Identifier: BSD-3-Clause
//
// The spatial slider-crank of [haug1989, Sec. 12.2] with the data of the benchmark library of IFToMM ("Spatial rigid
// slider-crank mechanism", https://www.iftomm-multibody.org/benchmark): a crank of 0.08 m that turns about x at
// (0, 0.1, 0.12) m, a rod of 0.3 m, a slider along x. The crank starts upright at 6 rad/s, its mass centre in its
// middle. Crank 0.12 kg, diag(1e-4, 1e-5, 1e-4) kg m^2; rod 0.5 kg, diag(4e-4, 4e-3, 4e-3) with x along the rod; slider
// 2 kg, 1e-4. The rod is on a spherical joint at the crank and on a universal one at the slider, whose axes are the
// line of the slider and the one perpendicular to it and to the rod. Tests compare it with solutions submitted to the
// library (tests/methods/published_numbers.cpp).
#include "problems/shapes.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model slider_crank(const Parameters& p) {
    const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
    const Real crank = decimal(0.08), rod = decimal(0.3);
    const Vec3 axle(0, decimal(0.1), decimal(0.12)), pin = axle + crank * z;
    const Real reach = sqrt(rod * rod - pin.squaredNorm());
    const Vec3 end = reach * x, along = (end - pin) / rod, across = x.cross(along).normalized();
    const Real w = p.scalar("speed");

    Model model;
    model.bodies.push_back({.name = "crank", .mass = decimal(0.12), .J = moments(1e-4, 1e-5, 1e-4)});
    model.bodies.push_back({.name = "rod", .mass = decimal(0.5), .J = moments(4e-4, 4e-3, 4e-3)});
    model.bodies.push_back({.name = "slider", .mass = 2, .J = moments(1e-4, 1e-4, 1e-4)});
    model.bodies[0].start = turning((axle + pin) / 2, Mat3::Identity(), axle, w * x);
    // The rod: v_pin + omega x (end - pin) = slide x, and no turning about the normal of the universal joint's axes.
    const Vec3 pin_velocity = (w * x).cross(pin - axle), normal = across.cross(x);
    const Real slide = pin_velocity.dot(along) / along[0];
    const Vec3 swing = along.cross(slide * x - pin_velocity) / rod;  // perpendicular to the rod
    const Vec3 omega = swing - swing.dot(normal) / along.dot(normal) * along;
    const Mat3 R = axes_along(along, along.cross(across));
    model.bodies[1].start = {(pin + end) / 2, R, (pin_velocity + slide * x) / 2, R.transpose() * omega};
    model.bodies[2].start = {.x = end, .v = slide * x};

    model.join(ground, 0, axle, "revolute", x);
    model.join(0, 1, pin);
    model.join(2, 1, end, "universal", x);
    model.joints.back().axes_second = model.axes_of(1, axes_about(across));
    model.join(ground, 2, end, "prismatic", x);
    model.gravity.g = p.vector("gravity");
    return model;
}

}  // namespace

KREISEL_PROBLEM(slider_crank,
                {.name = "slider_crank",
                 .summary = "spatial slider-crank of the IFToMM library: revolute, spherical, universal and "
                            "prismatic joint in a loop",
                 .cites = {"haug1989", "gonzalez2006"},
                 .parameters = {{"speed", ParameterKind::scalar, "rad/s", "initial speed of the crank", 6.0},
                                gravity_parameter({0, 0, -9.81})}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
