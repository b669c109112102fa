// SPDX-License-Identifier: BSD-3-Clause
//
// Both routes on mechanisms with prescribed coordinates and screws whose motion is known.
#include <algorithm>

#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"
#include "mechanics/parts/driven_joints.hpp"
#include "mechanics/start.hpp"
#include "tests/engine/two_routes.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

const Real driven_digits("1e-26");
const Real weight_of_kg = 10;

Body driven_body(const std::string& name, const Vec3& x) {
    Body body{.name = name, .mass = 3};
    body.J = Vec3(2, 3, 4).asDiagonal();
    body.J /= 8;
    body.start.x = x;
    return body;
}

struct BothRoutes {
    ReferenceSolution first;
    Taylor second;
};

BothRoutes driven_by_both(const Model& model, const Real& t) {
    BothRoutes both{reference_solution(model, t), taylor(model, t)};
    REQUIRE(both.first.stopped.empty());
    return both;
}

/// A nut on a vertical screw, both in the origin.
Model nut(const Real& lead) {
    Model model;
    model.bodies.push_back(driven_body("nut", Vec3::Zero()));
    model.gravity.g = Vec3(0, 0, -weight_of_kg);
    model.join(ground, 0, Vec3::Zero(), "screw", Vec3::UnitZ());
    model.joints[0].lead = lead;
    return model;
}

/// An arm on a vertical shaft that turns by f(t), and on the arm a pendulum that swings in the arm's plane.
Model pendulum_on_shaft(const Prescribed& f) {
    Model model;
    model.bodies.push_back(driven_body("arm", Vec3(1, 0, 0) / 2));
    model.bodies.push_back(driven_body("bob", Vec3(5, 0, -3) / 4));
    model.gravity.g = Vec3(0, 0, -weight_of_kg);
    model.join(ground, 0, Vec3::Zero(), driven("revolute", {.turn = true}), Vec3::UnitZ());
    model.joints[0].turn = f;
    model.join(0, 1, Vec3(1, 0, 0), "revolute", Vec3::UnitY());
    project_start(model);
    return model;
}

Real kinetic_energy(const Model& model, const std::vector<BodyState>& states) {
    Real sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i)
        sum += model.bodies[i].mass * states[i].v.squaredNorm() / 2 +
               states[i].omega.dot(model.bodies[i].J * states[i].omega) / 2;
    return sum;
}

/// E - rate L_z, the integral of Jacobi of a frame that turns about the vertical.
Real jacobi(const Model& model, const std::vector<BodyState>& states, const Real& rate) {
    Real sum = kinetic_energy(model, states);
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Body& body = model.bodies[i];
        const BodyState& s = states[i];
        const Vec3 momentum = s.x.cross(body.mass * s.v) + s.R * (body.J * s.omega);
        sum += body.mass * weight_of_kg * s.x[2] - rate * momentum[2];
    }
    return sum;
}

}  // namespace

TEST_CASE("a nut on a vertical screw falls with m g / (m + J (2 pi / lead)^2), turning by its thread") {
    for (const Real& lead : {Real(1) / 4, Real(-3)}) {
        const Model model = nut(lead);
        const Real radians = 2 * pi() / lead, m = model.bodies[0].mass, J = model.bodies[0].J(2, 2), t = 1;
        const Real fall = -m * weight_of_kg / (m + J * radians * radians) * t * t / 2;
        const BothRoutes both = driven_by_both(model, t);
        for (const std::vector<BodyState>& states : {both.first.states, both.second.states}) {
            CHECK((states[0].x - Vec3(0, 0, fall)).norm() < driven_digits);
            CHECK((states[0].R - SO3::exp(Vec3(0, 0, radians * fall))).norm() < driven_digits);
            CHECK((states[0].omega - Vec3(0, 0, radians * 2 * fall / t)).norm() < 10 * driven_digits);
        }
    }
}

TEST_CASE("a shaft makes ten turns as prescribed") {
    Model model;
    model.bodies.push_back(driven_body("shaft", Vec3::Zero()));
    model.join(ground, 0, Vec3::Zero(), driven("revolute", {.turn = true}), Vec3::UnitZ());
    model.joints[0].turn = {{0, 20 * pi()}, {{Real(1) / 2, 3, 0}}};
    project_start(model);
    const BothRoutes both = driven_by_both(model, 1);
    const Real angle = sin(Real(3)) / 2, rate = 20 * pi() + 3 * cos(Real(3)) / 2;
    const Real torque = -model.bodies[0].J(2, 2) * 9 * sin(Real(3)) / 2;
    for (const std::vector<BodyState>& states : {both.first.states, both.second.states}) {
        CHECK((states[0].R - SO3::exp(Vec3(0, 0, angle))).norm() < driven_digits);
        CHECK((states[0].omega - Vec3(0, 0, rate)).norm() < 100 * driven_digits);
    }
    CHECK(abs(both.first.multipliers[5] - torque) < 1000 * driven_digits);
    CHECK(abs(both.second.multipliers[5] - torque) < 1000 * driven_digits);
}

TEST_CASE("a slide moves as prescribed, pushed by its mass times the acceleration and its weight") {
    Model model;
    model.bodies.push_back(driven_body("lift", Vec3(1, 2, 0)));
    model.gravity.g = Vec3(0, 0, -weight_of_kg);
    model.join(ground, 0, Vec3(1, 0, 0), driven("prismatic", {.shift = true}), Vec3::UnitZ());
    model.joints[0].shift = {{0, 1, 2}, {{Real(1) / 2, -2, 0}}};
    project_start(model);
    const BothRoutes both = driven_by_both(model, 1);
    const Real height = 3 - sin(Real(2)) / 2, speed = 5 - cos(Real(2)),
               force = 3 * (weight_of_kg + 4 + 2 * sin(Real(2)));
    for (const std::vector<BodyState>& states : {both.first.states, both.second.states}) {
        CHECK((states[0].x - Vec3(1, 2, height)).norm() < driven_digits);
        CHECK((states[0].v - Vec3(0, 0, speed)).norm() < 10 * driven_digits);
    }
    CHECK(abs(both.first.multipliers[2] - force) < 1000 * driven_digits);
    CHECK(abs(both.second.multipliers[2] - force) < 1000 * driven_digits);
}

TEST_CASE("a pendulum on a shaft that turns evenly keeps the integral of Jacobi, on one that does not it loses it") {
    const Real rate = 3, t = 1;
    const Model even = pendulum_on_shaft({{0, rate}, {}});
    const Model uneven = pendulum_on_shaft({{0, rate}, {{Real(1) / 10, 2, 0}, {Real(-1) / 5, 1, 0}}});
    const auto change = [&](const Model& model, const std::vector<BodyState>& end) {
        std::vector<BodyState> start;
        for (const Body& body : model.bodies) start.push_back(body.start);
        return abs(jacobi(model, end, rate) - jacobi(model, start, rate));
    };
    const BothRoutes kept = driven_by_both(even, t), lost = driven_by_both(uneven, t);
    CHECK(change(even, kept.first.states) < 1000 * driven_digits);
    CHECK(change(even, kept.second.states) < 1000 * driven_digits);
    CHECK(change(uneven, lost.second.states) > Real(1) / 1000);
    CHECK(abs(kinetic_energy(even, kept.first.states) - kinetic_energy(even, kept.second.states)) <
          1000 * driven_digits);
}

TEST_CASE("a shaft that is locked holds as a fixed joint does, and the energy stays") {
    const auto has_energy = [](const Model& model) {
        const auto integrals = make_system(model, "SO3xR3")->integrals();
        return std::any_of(integrals.begin(), integrals.end(),
                           [](const FirstIntegral& integral) { return integral.name == "energy"; });
    };
    const Model locked = pendulum_on_shaft({{0, 0}, {{Real(1) / 2, 0, 0}}});
    Model fixed = locked;
    fixed.joints[0].type = "fixed";
    const BothRoutes held = driven_by_both(locked, 1), same = driven_by_both(fixed, 1);
    const std::vector<BodyState> start = {locked.bodies[0].start, locked.bodies[1].start};
    for (const std::vector<BodyState>& states : {held.first.states, held.second.states}) {
        const Distance d = distance(states, same.first.states);
        CHECK(max(max(d.position, d.rotation), max(d.velocity, d.omega)) < 100 * driven_digits);
        CHECK(abs(jacobi(locked, states, 0) - jacobi(locked, start, 0)) < 1000 * driven_digits);
    }
    CHECK(has_energy(locked));
    CHECK_FALSE(has_energy(pendulum_on_shaft({{0, 1}, {}})));
    CHECK_FALSE(has_energy(pendulum_on_shaft({{}, {{Real(1) / 2, 1, 0}}})));
    Model lift = locked;
    lift.joints[0].type = driven("prismatic", {.shift = true}), lift.joints[0].shift = {{Real(1) / 8}, {}};
    CHECK(has_energy(lift));
    lift.joints[0].shift.polynomial = {0, 0, 1};
    CHECK_FALSE(has_energy(lift));
}

TEST_CASE("a pendulum on a shaft that turns evenly stands out where weight and centrifugal force balance") {
    const Real angle = Real(1) / 2, arm = 1, length = 1;
    Model model;
    model.bodies.push_back(driven_body("arm", Vec3(1, 0, 0) / 2));
    Body bob{.name = "bob", .mass = 2, .point = true};
    bob.start.x = Vec3(arm + length * sin(angle), 0, -length * cos(angle));
    model.bodies.push_back(bob);
    model.gravity.g = Vec3(0, 0, -weight_of_kg);
    model.join(ground, 0, Vec3::Zero(), driven("revolute", {.turn = true}), Vec3::UnitZ());
    const Real rate = sqrt(weight_of_kg * tan(angle) / bob.start.x[0]);
    model.joints[0].turn = {{0, rate}, {}};
    Joint rod{.first = 0, .second = 1, .r_first = Vec3(1, 0, 0) / 2, .type = "distance", .length = length};
    model.joints.push_back(rod);
    model.bodies[1].start.v = Vec3(0, rate * bob.start.x[0], 0);
    project_start(model);
    const BothRoutes both = driven_by_both(model, 1);
    const Vec3 expected = SO3::exp(Vec3(0, 0, rate)) * bob.start.x;
    CHECK((both.first.states[1].x - expected).norm() < 100 * driven_digits);
    CHECK((both.second.states[1].x - expected).norm() < 100 * driven_digits);
}
