// SPDX-License-Identifier: BSD-3-Clause
//
// A thin disk that rolls on a horizontal plane without slipping, inclined, so its path is curved: two of its three
// constraints have no position level [neimarkfufaev1972, Sec. III.3]. Energy is conserved, momenta are not. Mass 1 kg,
// radius 0.5 m, moments of a uniform thin disk, m r^2/4 and m r^2/2. The numbers are our own choice.
#include "lie/so3.hpp"
#include "problems/shapes.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model disk(const Parameters& p) {
    Model model;
    const Real mass = p.mass("mass"), radius = p.scalar("radius");
    const Real transverse = mass * radius * radius / 4;
    Body body{.name = "disk", .mass = mass, .J = Vec3(transverse, transverse, 2 * transverse).asDiagonal()};
    // The axis of the disk is z of the body: along y in space when upright, then leaning about x.
    const Vec3 z = Vec3::UnitZ();
    const Mat3 R = SO3::exp(p.scalar("lean") * Vec3::UnitX()) * axes_along(Vec3::UnitX(), -Vec3::UnitY());
    const Vec3 axis = R * z, s = z - z.dot(axis) * axis, contact = -radius / s.norm() * s;
    const Vec3 omega = p.vector("omega");
    body.start = {-contact[2] * z, R, -(R * omega).cross(contact), omega};
    model.bodies.push_back(body);
    model.joints.push_back({.type = "rolling", .length = radius});
    model.gravity.g = p.scalar("gravity") * -z;
    return model;
}

}  // namespace

KREISEL_PROBLEM(disk,
                {.name = "rolling_disk",
                 .summary = "disk rolling on a plane without slipping: nonholonomic",
                 .cites = {"neimarkfufaev1972"},
                 .parameters = {
                     {"mass", ParameterKind::positive, "kg", "mass", 1.0},
                     {"radius", ParameterKind::positive, "m", "radius", 0.5},
                     {"lean", ParameterKind::scalar, "rad", "inclination of the disk at first; 0 is upright", 0.3},
                     {"omega", ParameterKind::vector, "rad/s",
                      "initial angular velocity, body axes; z is the axis of the disk", Vector3{0.2, 1, 6}},
                     {"gravity", ParameterKind::positive, "m/s^2", "against the normal of the plane", 9.81}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
