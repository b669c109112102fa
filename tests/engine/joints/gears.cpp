// SPDX-License-Identifier: BSD-3-Clause
//
// Both routes on wheels that mesh, with each other and with racks, whose motion is known.
#include "lie/so3.hpp"
#include "mechanics/parts/driven_joints.hpp"
#include "mechanics/start.hpp"
#include "tests/engine/two_routes.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

const Real gear_digits("1e-26");

Body toothed(const std::string& name, const Vec3& x) {
    Body body{.name = name, .mass = 2};
    body.J = Vec3(3, 5, 4).asDiagonal();
    body.J /= 16;
    body.start.x = x;
    return body;
}

const Real wheel_J = Real(1) / 4;  // of a wheel about z

/// Wheels about z at their centres, which mesh where the line of these has their teeth at the start.
void mesh_wheels(Model& model, int first, const Vec3& centre, int second, int z1, int z2) {
    const Vec3 other = model.bodies[static_cast<std::size_t>(second)].start.x;
    const Vec3 n = Vec3::UnitZ(), line = centre - other, e = (line - line.dot(n) * n).normalized();
    Mat3 axes;
    axes << e, n.cross(e), n;
    model.joints.push_back({.first = first,
                            .second = second,
                            .r_first = model.point_of(first, centre),
                            .type = "gear",
                            .axes_first = model.axes_of(first, axes),
                            .axes_second = model.axes_of(second, axes),
                            .teeth = {z1, z2}});
}

/// Two wheels on the ground, the first of which a torque turns.
Model geared(int z1, int z2, const Real& torque) {
    Model model;
    model.bodies = {toothed("one", Vec3(1, 2, 0)), toothed("two", Vec3(3, 1, 1))};
    for (int i : {0, 1})
        model.join(ground, i, model.bodies[static_cast<std::size_t>(i)].start.x, "revolute", Vec3::UnitZ());
    mesh_wheels(model, 0, model.bodies[0].start.x, 1, z1, z2);
    model.loads.push_back({.body = 0, .torque = Vec3(0, 0, torque)});
    return model;
}

Mat3 turned_about_z(const Real& angle) { return SO3::exp(Vec3(0, 0, angle)); }

std::vector<std::vector<BodyState>> gears_by_both(const Model& model, const Real& t) {
    const ReferenceSolution first = reference_solution(model, t);
    REQUIRE(first.stopped.empty());
    return {first.states, taylor(model, t).states};
}

/// Within half a turn, so that an exponential has it.
Real within_half_a_turn(const Real& angle) { return atan2(sin(angle), cos(angle)); }

}  // namespace

TEST_CASE("two wheels share a torque by their teeth, over several turns, a ring turns the same way") {
    for (const auto& [z1, z2] : {std::pair(17, 23), std::pair(12, 30), std::pair(20, -50)}) {
        const Real torque = 20, ratio = Real(z1) / z2, t = 1;
        const Real angle = torque / (wheel_J + wheel_J * ratio * ratio) * t * t / 2;
        REQUIRE(angle > 4 * pi());
        for (const auto& states : gears_by_both(geared(z1, z2, torque), t)) {
            CHECK((states[0].R - turned_about_z(within_half_a_turn(angle))).norm() < 100 * gear_digits);
            CHECK((states[1].R - turned_about_z(within_half_a_turn(-ratio * angle))).norm() < 100 * gear_digits);
            CHECK((states[1].omega - Vec3(0, 0, -ratio * 2 * angle / t)).norm() < 1000 * gear_digits);
        }
    }
}

TEST_CASE("a planet on a driven arm turns by 1 + z_sun / z_planet about the sun that stands") {
    Model model;
    model.bodies = {toothed("arm", Vec3(1, 0, 0)), toothed("planet", Vec3(2, 0, 0))};
    model.join(ground, 0, Vec3::Zero(), driven("revolute", {.turn = true}), Vec3::UnitZ());
    model.joints[0].turn = {{0, 2}, {{Real(1) / 4, 3, 0}}};
    model.join(0, 1, Vec3(2, 0, 0), "revolute", Vec3::UnitZ());
    mesh_wheels(model, ground, Vec3::Zero(), 1, 30, 20);
    project_start(model);
    const Real arm = 2 + sin(Real(3)) / 4, planet = arm * (1 + Real(30) / 20);
    for (const auto& states : gears_by_both(model, 1)) {
        CHECK((states[1].x - turned_about_z(arm) * Vec3(2, 0, 0)).norm() < 100 * gear_digits);
        CHECK((states[1].R - turned_about_z(within_half_a_turn(planet))).norm() < 100 * gear_digits);
    }
}

TEST_CASE("a pinion pushes a rack by its radius, whichever side the rack is on") {
    for (const int side : {1, -1}) {
        const Real radius = Real(1) / 2, torque = 20, t = 1;
        Model model;
        model.bodies = {toothed("rack", Vec3(1, side * radius, 0)), toothed("pinion", Vec3::Zero())};
        model.join(ground, 0, model.bodies[0].start.x, "prismatic", Vec3::UnitX());
        model.join(ground, 1, Vec3::Zero(), "revolute", Vec3::UnitZ());
        const Vec3 e = Vec3::UnitX(), n = Vec3::UnitZ();
        Joint joint{.first = 0, .second = 1, .type = "rack", .lead = -2 * pi() * side * radius};
        joint.axes_first << n, e.cross(n), e;
        const Real f = 2 * pi() / joint.lead;  // the rack's point is 1 m along it at the start
        joint.axes_second = SO3::exp(f * n) * (Mat3() << e, n.cross(e), n).finished();
        model.joints.push_back(joint);
        model.loads.push_back({.body = 1, .torque = Vec3(0, 0, torque)});
        const Real angle = torque / (wheel_J + 2 * radius * radius) * t * t / 2;
        for (const auto& states : gears_by_both(model, t)) {
            CHECK((states[1].R - turned_about_z(within_half_a_turn(angle))).norm() < 100 * gear_digits);
            CHECK((states[0].x - Vec3(1 - side * radius * angle, side * radius, 0)).norm() < 100 * gear_digits);
        }
    }
}
