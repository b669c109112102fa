// SPDX-License-Identifier: BSD-3-Clause
//
// Mechanisms with more constraint rows than they need, as people simulate them, and the same mechanism in other units.
#pragma once

#include "mechanics/start.hpp"
#include "tests/methods/stepping.hpp"

namespace linkages {

using namespace kreisel;
using namespace models;

inline Body bar(const std::string& name, const Real& mass, const Vec3& from, const Vec3& to) {
    const Vec3 along = to - from;
    const Real length = along.norm(), moment = mass * length * length / 12;
    Mat3 J = Mat3::Zero();
    J.diagonal() << moment / 10, moment, moment;
    Mat3 R;
    R << along / length, Vec3(abs(along[2]) < length / 2 ? Vec3::UnitZ() : Vec3::UnitX()), Vec3::Zero();
    R.col(1) = Vec3(R.col(1) - R.col(0).dot(R.col(1)) * R.col(0)).normalized();
    R.col(2) = Vec3(R.col(0)).cross(Vec3(R.col(1)));
    return {.name = name, .mass = mass, .J = J, .start = {.x = (from + to) / 2, .R = R}};
}

/// Adds a bar and returns its index.
inline int add_bar(Model& model, const std::string& name, const Real& mass, const Vec3& from, const Vec3& to) {
    model.bodies.push_back(bar(name, mass, from, to));
    return static_cast<int>(model.bodies.size()) - 1;
}

/// Unequal bars on four hinges along z: 20 rows, rank 17.
inline Model planar_four_bar() {
    const Vec3 a(0, 0, 0), b(0, 1, 0), c(Real(3) / 2, Real(8) / 5, 0), d(2, 0, 0), z = Vec3::UnitZ();
    Model model;
    const int crank = add_bar(model, "crank", 1, a, b), coupler = add_bar(model, "coupler", 2, b, c),
              rocker = add_bar(model, "rocker", Real(3) / 2, c, d);
    model.join(ground, crank, a, "revolute", z);
    model.join(crank, coupler, b, "revolute", z);
    model.join(coupler, rocker, c, "revolute", z);
    model.join(rocker, ground, d, "revolute", z);
    model.bodies[0].start.omega = -model.bodies[0].start.R.transpose() * z;
    model.gravity.g = Vec3(0, -9, 0);
    project_start(model);
    return model;
}

/// Scott Russell's straight-line mechanism twice on one bar: its ends slide along x and y, and two cranks from the
/// origin hold its middle. One freedom, and each part by itself suffices.
inline Model double_scott_russell() {
    const Vec3 o(0, 0, 0), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const Vec3 right(Real(8) / 5, 0, 0), top(0, Real(6) / 5, 0), middle = (right + top) / 2;
    Model model;
    const int rod = add_bar(model, "rod", 2, right, top), first = add_bar(model, "first crank", 1, o, middle),
              second = add_bar(model, "second crank", 1, o, middle);
    for (const auto& [name, place] : {std::pair("slider on x", right), std::pair("slider on y", top)}) {
        Body slider{.name = name, .mass = 1, .J = Mat3::Identity() / 50, .start = {.x = place}};
        model.bodies.push_back(slider);
    }
    for (const int crank : {first, second}) {
        model.join(ground, crank, o, "revolute", z);
        model.join(crank, rod, middle, "revolute", z);
    }
    model.join(ground, 3, right, "prismatic", x);
    model.join(3, rod, right, "revolute", z);
    model.join(ground, 4, top, "prismatic", y);
    model.join(4, rod, top, "revolute", z);
    model.bodies[1].start.omega = model.bodies[1].start.R.transpose() * z;
    model.gravity.g = Vec3(1, -9, 0);
    project_start(model);
    return model;
}

/// Two parallel shafts along z, and between them two Cardan shafts side by side, each with a joint at both ends in the
/// phase that keeps the speeds equal: each branch by itself suffices.
inline Model parallel_cardan_branches() {
    const Vec3 z = Vec3::UnitZ();
    Model model;
    const auto shaft = [&](const std::string& name, const Vec3& foot) {
        const int number = add_bar(model, name, 2, foot, foot + z);
        model.join(ground, number, foot, "revolute", z);
        return number;
    };
    const int driving = shaft("driving", Vec3(0, 0, 0)), driven = shaft("driven", Vec3(1, 0, 4));
    for (const Real& place : {Real(0), Real(1) / 2}) {
        const Vec3 P(0, 0, 1 + place), Q(1, 0, 4 + place), along = (Q - P).normalized();
        const Vec3 across = z.cross(along).normalized(), other = along.cross(across);
        const int cardan = add_bar(model, "cardan" + std::to_string(model.bodies.size()), 1, P, Q);
        for (const auto& [body, point] : {std::pair(driving, P), std::pair(driven, Q)}) {
            model.join(body, cardan, point, "universal", across);
            model.joints.back().axes_second = model.axes_of(cardan, axes_about(other));
        }
    }
    model.bodies[0].start.omega = model.bodies[0].start.R.transpose() * Vec3(0, 0, 3);
    model.gravity.g = Vec3(2, -9, 1);
    project_start(model);
    return model;
}

inline std::vector<Named> redundant_linkages() {
    return {{"planar four-bar", planar_four_bar()},
            {"double Scott Russell", double_scott_russell()},
            {"parallel Cardan branches", parallel_cardan_branches()},
            {"four_bar", standard("four_bar")},
            {"bricard", standard("bricard")}};
}

/// Lengths in units of L metres, masses in units of m kilograms, the origin moved; forces follow, so that the motion is
/// the same. Without springs.
inline Model in_units(Model model, const Real& length, const Real& mass, const Vec3& origin = Vec3::Zero()) {
    for (Body& body : model.bodies) {
        body.mass *= mass;
        body.J *= mass * length * length;
        body.start.x = length * body.start.x + origin, body.start.v *= length;
    }
    for (Joint& joint : model.joints) {
        joint.r_first *= length, joint.r_second *= length, joint.length *= length;
        if (joint.first == ground) joint.r_first += origin;
        if (joint.second == ground) joint.r_second += origin;
    }
    model.gravity.g *= length;
    return model;
}

/// Largest distance of two states of such a model and its original, in the original's units.
inline Real distance_in_units(const std::vector<BodyState>& large, const std::vector<BodyState>& one,
                              const Real& length, const Vec3& origin = Vec3::Zero()) {
    std::vector<BodyState> back = large;
    for (BodyState& state : back) state.x = (state.x - origin) / length, state.v /= length;
    return stepping::worst(distance(back, one));
}

}  // namespace linkages
