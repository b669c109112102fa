// SPDX-License-Identifier: BSD-3-Clause
//
// Two rigid links: "upper" on a spherical joint at the origin, "lower" on a spherical joint at (1, 0, 0) between the
// two, in constant gravity. The default start is not planar; the velocities follow from the joints. The data are our
// own.
#include "problems/problem.hpp"
#include "problems/reading/bodies.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model double_pendulum(const Parameters& p) {
    const auto& links = p.bodies("bodies");
    if (links.size() != 2)
        throw ParameterError("/bodies",
                             "expected two bodies, the upper and the lower link, got " + std::to_string(links.size()));
    for (std::size_t i = 0; i < links.size(); ++i)
        if (links[i].point)
            throw ParameterError("/bodies/" + std::to_string(i) + "/type",
                                 "expected a rigid body: a point mass cannot be held away from its mass centre");
    Model model;
    read_bodies(model, links);
    model.join(ground, 0, Vec3::Zero());
    model.join(0, 1, Vec3::UnitX());
    complete_velocities(model, given_velocities(links));
    model.gravity.g = p.vector("gravity");
    return model;
}

std::vector<BodyData> links() {
    return {{.name = "upper",
             .mass = 1,
             .inertia = diagonal(0.01, 0.09, 0.085),
             .x = {0.5, 0, 0},
             .omega = Vector3{0.5, 1, -0.3}},
            {.name = "lower",
             .mass = 0.6,
             .inertia = diagonal(0.006, 0.04, 0.035),
             .x = {1, 0.4, 0},
             .R = {0, -1, 0, 1, 0, 0, 0, 0, 1},
             .omega = Vector3{-1, 0.2, 0.8}}};
}

}  // namespace

KREISEL_PROBLEM(double_pendulum,
                {.name = "double_pendulum",
                 .summary = "two rigid links on spherical joints, non-planar start; chaotic over long times",
                 .cites = {},
                 .parameters = {
                     {"bodies", ParameterKind::bodies, "", "the upper and the lower link", links()},
                     {"gravity", ParameterKind::vector, "m/s^2", "gravity, space axes", Vector3{0, 0, -9.81}}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
