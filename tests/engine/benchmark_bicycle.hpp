// SPDX-License-Identifier: BSD-3-Clause
//
// The benchmark bicycle [meijaard2007, Table 1] as four bodies on three hinges and two rolling joints. The axes of the
// source have z down; here it is up, y to the left, and products of inertia have the opposite sign.
#pragma once

#include "lie/so3.hpp"
#include "mechanics/start.hpp"

namespace reference_tests {

using namespace kreisel;

enum { rear_wheel, rear_body, front_frame, front_wheel };

inline Real at(const char* text) { return from_text(text); }

inline Mat3 inertia(const char* xx, const char* yy, const char* zz, const char* xz = "0") {
    Mat3 J;
    J << at(xx), 0, at(xz), 0, at(yy), 0, at(xz), 0, at(zz);
    return J;
}

/// Through the ground 0.08 m, the trail, before the front contact, and leaning back by pi/10.
inline Vec3 steer_axis() { return {-sin(pi() / 10), 0, cos(pi() / 10)}; }
inline Vec3 foot_of_steer_axis() { return {at("1.02") + at("0.08"), 0, 0}; }

inline Joint rolling(int wheel, const Real& radius) {
    Joint joint{.second = wheel, .type = "rolling", .length = radius};
    joint.axes_second = axes_about(Vec3::UnitY());
    return joint;
}

/// Upright and straight ahead at speed v.
inline Model bicycle(const Real& v) {
    const Real rear = at("0.3"), front = at("0.35"), wheelbase = at("1.02");
    const Vec3 y = Vec3::UnitY();
    Model model;
    model.bodies = {{.name = "rear_wheel", .mass = 2, .J = inertia("0.0603", "0.12", "0.0603")},
                    {.name = "rear_body", .mass = 85, .J = inertia("9.2", "11", "2.8", "-2.4")},
                    {.name = "front_frame", .mass = 4, .J = inertia("0.05892", "0.06", "0.00708", "0.00756")},
                    {.name = "front_wheel", .mass = 3, .J = inertia("0.1405", "0.28", "0.1405")}};
    const Vec3 places[] = {{0, 0, rear}, {rear, 0, at("0.9")}, {at("0.9"), 0, at("0.7")}, {wheelbase, 0, front}};
    for (std::size_t i = 0; i < 4; ++i) model.bodies[i].start = {places[i], Mat3::Identity(), v * Vec3::UnitX()};
    model.bodies[rear_wheel].start.omega = v / rear * y;
    model.bodies[front_wheel].start.omega = v / front * y;
    model.joints.push_back(rolling(rear_wheel, rear));
    model.join(rear_body, rear_wheel, places[rear_wheel], "revolute", y);
    model.join(rear_body, front_frame, foot_of_steer_axis(), "revolute", steer_axis());
    model.join(front_frame, front_wheel, places[front_wheel], "revolute", y);
    model.joints.push_back(rolling(front_wheel, front));
    model.gravity.g = -at("9.81") * Vec3::UnitZ();
    return model;
}

/// Rotates a body, its pose and velocity, about a line through P by the vector `angle`.
inline void turn(Body& body, const Vec3& P, const Vec3& angle) {
    const Mat3 Q = SO3::exp(angle);
    body.start.x = P + Q * (body.start.x - P);
    body.start.R = Q * body.start.R;
    body.start.v = Q * body.start.v;
}

/// Leaning by 1e-10 and steered by twice as much, on the constraints.
inline Model disturbed(Model model) {
    const Real lean = at("1e-10");
    for (const int body : {front_frame, front_wheel})
        turn(model.bodies[static_cast<std::size_t>(body)], foot_of_steer_axis(), 2 * lean * steer_axis());
    for (Body& body : model.bodies) turn(body, Vec3::Zero(), lean * Vec3::UnitX());
    project_start(model);
    return model;
}

}  // namespace reference_tests
