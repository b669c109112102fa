// SPDX-License-Identifier: BSD-3-Clause
//
// The stiff flyball governor, problem A05 of the library of IFToMM [gonzalez2006]: a vertical shaft, two rods hinged at
// its top that carry 5 kg at their ends, and a slider on the shaft, held by springs of 8e5 N/m with dampers of 4e4 N
// s/m between it and the middles of the rods. Shaft and rods 1 x 0.01 x 0.01 m, slider 0.1 m cubed, 3000 kg/m^3.
// Everything rotates at 2 pi rad/s at first, the rods 30 degrees below the horizontal, the slider 0.5 m below the top,
// where the springs have their free length, 0.5 m.
#include "problems/shapes.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// A rod along the body axis x, with a point mass at its end, about their common mass centre at `centre` from the
/// hinge.
Body loaded_rod(const Real& length, const Real& width, const Real& density, const Real& ball, Real& centre) {
    const Real mass = density * length * width * width;
    Body body{.mass = mass + ball};
    centre = (mass * length / 2 + ball * length) / body.mass;
    const Real a = length / 2 - centre, b = length - centre, extra = mass * a * a + ball * b * b;
    body.J = box_inertia(mass, length, width, width) + Mat3(Vec3(0, extra, extra).asDiagonal());
    return body;
}

Model governor(const Parameters& p) {
    const Real length = 1, width = decimal(0.01), density = 3000, cube = decimal(0.1);
    const Vec3 y = Vec3::UnitY(), z = Vec3::UnitZ(), top = length * z, slide = length / 2 * z;
    const Vec3 w = p.scalar("speed") * z;
    Model model;
    const Real shaft = density * length * width * width, box = density * cube * cube * cube;
    model.bodies.push_back({.name = "shaft", .mass = shaft, .J = box_inertia(shaft, width, width, length)});
    model.bodies.push_back({.name = "slider", .mass = box, .J = box_inertia(box, cube, cube, cube)});
    model.bodies[0].start = turning(length / 2 * z, Mat3::Identity(), top, w);
    model.bodies[1].start = turning(slide, Mat3::Identity(), top, w);
    model.join(ground, 0, Vec3::Zero(), "revolute", z);
    model.join(0, 1, slide, "prismatic", z);
    for (const int side : {1, -1}) {
        Real centre = 0;
        Body rod = loaded_rod(length, width, density, p.mass("ball"), centre);
        rod.name = side > 0 ? "right_rod" : "left_rod";
        const Vec3 along(side * sqrt(Real(3)) / 2, 0, -Real(1) / 2);
        Mat3 R;
        R << along, y, along.cross(y);
        rod.start = turning(top + centre * along, R, top, w);
        model.bodies.push_back(rod);
        const int body = static_cast<int>(model.bodies.size()) - 1;
        model.join(0, body, top, "revolute", y);
        model.springs.push_back({1, body, Vec3::Zero(), (length / 2 - centre) * Vec3::UnitX(), p.scalar("stiffness"),
                                 p.scalar("damping"), length / 2});
    }
    model.gravity.g = p.vector("gravity");
    return model;
}

}  // namespace

// 2 pi to 16 digits.
KREISEL_PROBLEM(governor,
                {.name = "flyball_governor",
                 .summary = "stiff flyball governor (IFToMM A05): springs and dampers in place of coupler rods",
                 .cites = {"gonzalez2006"},
                 .parameters = {
                     {"speed", ParameterKind::scalar, "rad/s", "initial speed about the vertical", 6.283185307179586},
                     {"ball", ParameterKind::positive, "kg", "mass at the end of each rod", 5.0},
                     {"stiffness", ParameterKind::positive, "N/m", "of each spring", 8e5},
                     {"damping", ParameterKind::scalar, "N s/m", "of each damper", 4e4},
                     gravity_parameter({0, 0, -9.81})}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
