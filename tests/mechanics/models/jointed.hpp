// SPDX-License-Identifier: BSD-3-Clause
//
// Models with joints of every kind, to the ground and between bodies in both directions, with springs, dampers and a
// driven length or a prescribed coordinate; nothing in them is aligned with an axis.
#pragma once

#include "mechanics/parts/driven_joints.hpp"
#include "mechanics/start.hpp"
#include "tests/mechanics/models/linked.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace models {

/// Every joint but those that roll.
inline const std::vector<JointType>& joint_types() {
    static const std::vector<JointType> all = [] {
        std::vector<JointType> types;
        for (const JointKind& kind : joint_kinds())
            if (!kind.has(Primitive::contact)) types.emplace_back(kind);
        return types;
    }();
    return all;
}

/// Every joint with a prescribed coordinate.
inline std::vector<JointType> driven_types() {
    std::vector<JointType> types;
    for (const JointKind& kind : driven_kinds()) types.emplace_back(kind);
    return types;
}

/// Gives a joint what its rows need of coordinates along and about its axis.
inline void prescribe(Joint& joint) {
    if (joint.type->has(Primitive::turn)) joint.turn = {{0, 1, Real(1) / 2}, {{Real(1) / 4, 3, 0}}};
    if (joint.type->has(Primitive::shift)) joint.shift = {{0, Real(-1) / 2, 1}, {{Real(1) / 8, 2, 0}}};
    if (joint.type->has(Primitive::helix)) joint.lead = Real(3) / 4;
    if (joint.type->has(Primitive::rack)) joint.lead = Real(-5) / 2;
    if (joint.type->has(Primitive::mesh)) joint.teeth = {3, -5};
}

/// A joint of any kind but rolling between two bodies as they stand.
inline void join(Model& model, int first, int second, JointType type, const Vec3& point) {
    model.join(first, second, point, type, Vec3(1, -2, 2 + second));
    Joint& joint = model.joints.back();
    if (type->axes == JointAxes::perpendicular) {
        const Vec3 other = Vec3(2, 1 + second, -1).cross(Vec3(1, -2, 2 + second));
        joint.axes_second = model.axes_of(second, axes_about(other));
    }
    if (type->has(Primitive::mesh)) joint.r_first += Vec3(1, 2, -1) / 3;
    if (type->has(Primitive::distance)) {
        joint.r_first += Vec3(1, 2, -1) / 3;
        const auto at = [&](int body, const Vec3& r) -> Vec3 {
            if (body == ground) return r;
            const BodyState& start = model.bodies[static_cast<std::size_t>(body)].start;
            return start.x + start.R * r;
        };
        joint.length = (at(first, joint.r_first) - at(second, joint.r_second)).norm();
    }
    prescribe(joint);
}

/// ground - b0, b1 - b0 and b1 - b2 by joints of one kind.
inline Model jointed(JointType type) {
    Model model = bodies_in_a_row(3);
    join(model, ground, 0, type, Vec3(1, -1, 2) / 3);
    join(model, 1, 0, type, Vec3(1, 2, 0) / 3);
    join(model, 1, 2, type, Vec3(5, 2, -4) / 3);
    model.gravity = {Vec3(1, -2, -9), Real(1) / 2, 3};
    project_start(model);
    return model;
}

/// The same with springs that hold every body to another or to the ground.
inline Model sprung(JointType type) {
    Model model = jointed(type);
    model.gravity.amplitude = 0;
    model.springs = {{ground, 2, Vec3(3, 1, 0), Vec3(1, 0, 2) / 4, 20, 0, Real(1) / 2},
                     {0, 1, Vec3(0, 1, 0), Vec3(1, 0, 0), 7, 0, 0}};
    model.torsion_springs = {{0, 2, axes_about(Vec3(1, 1, 3)), axes_about(Vec3(2, -1, 1)), 3, 0, Real(1) / 4}};
    return model;
}

inline Model damped(JointType type) {
    Model model = sprung(type);
    for (Spring& spring : model.springs) spring.damping = 3;
    model.torsion_springs[0].damping = 2;
    return model;
}

/// The same with a force of each type that bends with the mechanism: a spring of a polynomial law, a bushing and
/// attractions, without what depends on velocities.
inline Model bent(JointType type) {
    Model model = jointed(type);
    model.gravity.amplitude = 0;
    PolynomialSpring spring;
    spring.second = 2, spring.r_first = Vec3(3, 1, 0), spring.r_second = Vec3(1, 0, 2) / 4;
    spring.coefficients = {5, -1, Real(1) / 2}, spring.length = Real(1) / 2;
    model.polynomial_springs.push_back(spring);
    const Vec3 place(2, 1, -1);
    const Mat3 axes = axes_about(Vec3(1, -2, 2));
    model.bushings.push_back({.first = 0,
                              .second = 2,
                              .r_first = model.point_of(0, place),
                              .r_second = model.point_of(2, place + Vec3(1, 2, -1) / 8),
                              .axes_first = model.axes_of(0, axes),
                              .axes_second = model.axes_of(2, axes * SO3::exp(Vec3(-1, 2, 1) / 8)),
                              .stiffness = {Vec3(4, 2, 3), Vec3(1, 3, 2)}});
    model.attractions = {{ground, 1, Vec3(4, 3, -5), Vec3::Zero(), 20}, {0, 2, Vec3::Zero(), Vec3::Zero(), 3}};
    return model;
}

/// And damped.
inline Model softened(JointType type) {
    Model model = bent(type);
    model.polynomial_springs[0].damping = 1;
    model.bushings[0].damping = {Vec3(1, 2, 1) / 2, Vec3(2, 1, 3) / 4};
    model.dampers = {{ground, 2, Vec3(1, 0, 2) / 4, Real(1) / 2}, {0, 1, Vec3(0, 1, -1) / 3, 1}};
    model.rotational_dampers = {{ground, 1, Real(1) / 4}, {2, 0, Real(1) / 2}};
    return model;
}

/// A body on a rod whose length is driven, and a second one on it.
inline Model driven() {
    Model model = bodies_in_a_row(2);
    join(model, ground, 0, "distance", Vec3(1, -1, 2));
    join(model, 0, 1, "distance", Vec3(1, 2, 0));
    for (Joint& joint : model.joints) joint.amplitude = Real(1) / 4, joint.frequency = 3;
    project_start(model);
    return model;
}

/// A disk that rolls on an inclined plane beside a body on a hinge.
inline Model rolling() {
    Model model = bodies_in_a_row(2);
    model.bodies[0].start.omega = Vec3(1, -3, 2);
    model.joints.push_back({.second = 0,
                            .r_first = Vec3(0, 0, -1),
                            .r_second = Vec3(1, 0, 2) / 16,
                            .type = "rolling",
                            .axes_first = axes_about(Vec3(1, -1, 8)),
                            .axes_second = axes_about(Vec3(1, 4, 1)),
                            .length = Real(3) / 4});
    model.join(ground, 1, Vec3(1, 1, 1), "revolute", Vec3(1, 2, 3));
    model.gravity.g = Vec3(1, -2, -9);
    project_start(model);
    return model;
}

/// Two wheels on the ground, with their weight off the axes, and a rack that the second one moves.
inline Model meshing() {
    Model model = bodies_in_a_row(3);
    const Vec3 n = Vec3(1, 2, 3).normalized(), centres[] = {Vec3(1, -1, 2) / 3, Vec3(4, 2, -2) / 3};
    for (const int i : {0, 1}) model.join(ground, i, centres[i], "revolute", n);
    const Vec3 line = centres[0] - centres[1], e = (line - line.dot(n) * n).normalized(), across = n.cross(e);
    Mat3 wheel, rack;
    wheel << e, across, n;
    rack << n, e.cross(n), e;
    model.joints.push_back({.first = 0,
                            .second = 1,
                            .r_first = model.point_of(0, centres[0]),
                            .r_second = model.point_of(1, centres[1]),
                            .type = "gear",
                            .axes_first = model.axes_of(0, wheel),
                            .axes_second = model.axes_of(1, wheel),
                            .teeth = {17, 23}});
    model.join(ground, 2, Vec3(5, 2, -4) / 3, "prismatic", e);
    model.joints.push_back({.first = 2,
                            .second = 1,
                            .r_first = model.point_of(2, centres[1] - across / 2),
                            .r_second = model.point_of(1, centres[1]),
                            .type = "rack",
                            .axes_first = model.axes_of(2, rack),
                            .axes_second = model.axes_of(1, wheel),
                            .lead = pi()});
    model.gravity.g = Vec3(1, -2, -9);
    project_start(model);
    return model;
}

/// A closed loop of four bars, the ground one of them: hinge, spherical, universal and cylindrical joint, 16 rows for
/// 18.
inline Model closed_loop() {
    Model model = bodies_in_a_row(3);
    join(model, ground, 0, "revolute", Vec3(-1, 1, 0));
    join(model, 0, 1, "spherical", Vec3(1, 1, -1) / 2);
    join(model, 1, 2, "universal", Vec3(3, 1, -3) / 2);
    join(model, 2, ground, "cylindrical", Vec3(3, 0, -1));
    model.gravity.g = Vec3(1, -2, -9);
    project_start(model);
    return model;
}

/// n hinges on one line between two bodies, or a body and the ground: 5 independent rows for any n.
inline Model hinges_in_line(int first, int n) {
    Model model = bodies_in_a_row(2);
    const Vec3 axis(1, -2, 4);
    if (first != ground) join(model, ground, 0, "spherical", Vec3(-1, 0, 1));
    for (int i = 0; i < n; ++i) model.join(first, 1, Vec3(1, 1, 1) + axis * i / 4, "revolute", axis);
    model.gravity.g = Vec3(1, -2, -9);
    project_start(model);
    return model;
}

}  // namespace models
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
