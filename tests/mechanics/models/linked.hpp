// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies without any symmetry, single and linked by spherical joints.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace models {

inline Body asymmetric_body(int i) {
    Body body{.name = "b" + std::to_string(i), .mass = Real(1) + Real(i) / 4};
    body.J << 3, 1, -1, 1, 5, 1, -1, 1, 4;
    body.J /= 10;
    body.start = {Vec3(i, Real(i) / 3, -i), SO3::exp(Vec3(i, 1, Real(-i) / 2) / 4), Vec3::Zero(),
                  Vec3(1, Real(i) / 2, -1)};
    return body;
}

inline Model bodies_in_a_row(int bodies) {
    Model model;
    for (int i = 0; i < bodies; ++i) model.bodies.push_back(asymmetric_body(i));
    return model;
}

inline Model linked(int bodies, const std::vector<std::pair<int, int>>& links) {
    Model model = bodies_in_a_row(bodies);
    for (const auto& [first, second] : links) {
        const Vec3 a = first == ground ? Vec3(1, 1, 0) : model.bodies[static_cast<std::size_t>(first)].start.x;
        const Vec3 b = model.bodies[static_cast<std::size_t>(second)].start.x;
        model.join(first, second, (a + b) / 2 + Vec3(Real(second) / 5, Real(1) / 4, 0));
    }
    complete_velocities(model, std::vector<bool>(model.bodies.size(), false));
    model.gravity = {Vec3(1, -2, -9), Real(1) / 2, 3};
    return model;
}

}  // namespace models
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
