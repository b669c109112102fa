// SPDX-License-Identifier: BSD-3-Clause
//
// Models compared with Simbody.
#pragma once

#include "mechanics/start.hpp"
#include "tests/mechanics/models/models.hpp"

namespace outside {

using namespace kreisel;

/// Three bodies that differ in everything, on spherical joints from the ground on, no joint on an axis of a body.
inline Model three_bodies() {
    Model model;
    const Vec3 principal[] = {{3, 5, 6}, {2, 9, 8}, {7, 4, 5}};
    for (int i = 0; i < 3; ++i) {
        const Mat3 axes = SO3::exp(Vec3(1 + i, -1, Real(i) / 2));
        Body body{.name = "b" + std::to_string(i), .mass = Real(3 - i) / 2 + Real(1) / 4};
        body.J = axes * (principal[i] / 20).asDiagonal() * axes.transpose();
        body.J = (body.J + Mat3(body.J.transpose())) / 2;
        body.start = {Vec3(1 + i, Real(i * i) / 3, -i), SO3::exp(Vec3(i, 1, -1) / 3), Vec3::Zero(), Vec3(2, i, -1)};
        model.bodies.push_back(body);
    }
    model.join(ground, 0, Vec3(1, -1, 1) / 4);
    model.join(0, 1, Vec3(7, 1, -2) / 4);
    model.join(2, 1, Vec3(9, 3, -7) / 4);  // the tree of joint coordinates has this one reversed
    model.gravity.g = Vec3(1, -2, -9);
    project_start(model);
    return model;
}

/// The model with its gravity and its loads as they are at a time and in a pose, constant and in space axes, prescribed
/// coordinates as they are there at time 0, and without torsion springs.
inline Model frozen(Model model, const Real& t, const std::vector<BodyState>& bodies) {
    model.gravity = {model.gravity.at(t)};
    for (Load& load : model.loads) {
        const Real factor = 1 + load.amplitude * sin(load.frequency * t);
        const bool turns = load.axes == Load::Axes::body;
        const Mat3 axes = turns ? bodies[static_cast<std::size_t>(load.body)].R : Mat3(Mat3::Identity());
        load = {load.body, Load::Axes::space, axes * load.force * factor, axes * load.torque * factor, 0,
                0,         load.point};
    }
    for (Joint& joint : model.joints)
        for (Prescribed* law : {&joint.turn, &joint.shift}) {
            if (law->is_zero()) continue;
            const auto [f, rate, second] = law->at(t);
            *law = {{f, rate, second / 2}, {}};
        }
    model.torsion_springs.clear();
    return model;
}

}  // namespace outside
