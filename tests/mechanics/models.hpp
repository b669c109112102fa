// SPDX-License-Identifier: BSD-3-Clause
//
// Models with every pattern of the joint graph: one joint, a chain, a star, a closed loop, a body with no joint.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"
#include "problems/problem.hpp"

namespace models {

using namespace kreisel;

inline ParameterValues defaults(const Problem& problem) {
    ParameterValues values;
    for (const ParameterDescription& parameter : problem.description.parameters)
        values[parameter.name] = parameter.standard;
    return values;
}

inline Model standard(const std::string& name) {
    const ParameterValues values = defaults(problem(name));
    return problem(name).build(Parameters(values));
}

inline Body asymmetric_body(int i) {
    Body body{.name = "b" + std::to_string(i), .mass = Real(1) + Real(i) / 4};
    body.J << 3, 1, -1, 1, 5, 1, -1, 1, 4;
    body.J /= 10;
    body.start = {Vec3(i, Real(i) / 3, -i), SO3::exp(Vec3(i, 1, Real(-i) / 2) / 4), Vec3::Zero(),
                  Vec3(1, Real(i) / 2, -1)};
    return body;
}

struct Named {
    std::string name;
    Model model;
};

inline Model linked(int bodies, const std::vector<std::pair<int, int>>& links) {
    Model model;
    for (int i = 0; i < bodies; ++i) model.bodies.push_back(asymmetric_body(i));
    for (const auto& [first, second] : links) {
        const Vec3 a = first == ground ? Vec3(1, 1, 0) : model.bodies[static_cast<std::size_t>(first)].start.x;
        const Vec3 b = model.bodies[static_cast<std::size_t>(second)].start.x;
        model.join(first, second, (a + b) / 2 + Vec3(Real(second) / 5, Real(1) / 4, 0));
    }
    complete_velocities(model, std::vector<bool>(model.bodies.size(), false));
    model.gravity = {Vec3(1, -2, -9), Real(1) / 2, 3};
    return model;
}

/// A closed loop that turns as one about the line through its two ground joints: the start that satisfies all joints.
inline Model loop() {
    Model model = linked(4, {{ground, 0}, {0, 1}, {1, 2}, {2, 3}, {ground, 3}});
    const Vec3 P = model.joints.front().r_first, axis = model.joints.back().r_first - P;
    for (Body& body : model.bodies) {
        body.start.omega = body.start.R.transpose() * axis;
        body.start.v = axis.cross(body.start.x - P);
    }
    return model;
}

/// One load in each kind of axes on the last body.
inline Model loaded(Model model) {
    const int last = static_cast<int>(model.bodies.size()) - 1;
    model.loads.push_back({last, Load::Axes::space, Vec3(3, -1, 2), Vec3(1, 2, -1), Real(1) / 2, 3});
    model.loads.push_back({last, Load::Axes::body, Vec3(-1, 2, 1), Vec3(2, -1, 3), Real(1) / 4, 2});
    return model;
}

inline std::vector<Named> all() {
    return {{"heavy_top", standard("heavy_top")},
            {"forced_heavy_top", standard("forced_heavy_top")},
            {"double_pendulum", standard("double_pendulum")},
            {"free_top", standard("free_top")},
            {"loaded top", loaded(standard("forced_heavy_top"))},
            {"loaded chain", loaded(linked(3, {{ground, 0}, {0, 1}, {1, 2}}))},
            {"chain", linked(5, {{ground, 0}, {0, 1}, {1, 2}, {2, 3}, {3, 4}})},
            {"mixed chain", linked(4, {{ground, 0}, {1, 0}, {1, 2}, {3, 2}})},
            {"star", linked(4, {{ground, 0}, {0, 1}, {0, 2}, {0, 3}})},
            {"loop", loop()},
            {"two anchors", linked(2, {{ground, 0}, {ground, 1}})},
            {"floating pair", linked(2, {{0, 1}})}};
}

inline std::vector<std::string> applicable(const Model& model) {
    std::vector<std::string> names;
    for (const Formulation& entry : formulations())
        if (entry.why_not(model).empty()) names.push_back(entry.name);
    return names;
}

}  // namespace models
