// SPDX-License-Identifier: BSD-3-Clause
//
// Joints between axes that point in different directions, as a config gives them: project_initial turns bodies by the
// angle between the axes and about nothing else, whatever the joint measures from there.
#include <catch2/catch.hpp>

#include "lie/so3.hpp"
#include "problems/problem.hpp"

namespace directed_axes {

using namespace kreisel;

namespace {

const Vector3 origin = {0, 0, 0}, standing = {1, 2, 2};

Vector3 to_data(const Vec3& a) { return {to_double(a[0]), to_double(a[1]), to_double(a[2])}; }

/// At an angle from the standing axis, along no axis of space; a decimal, so that it holds to doubles only.
Vector3 apart_by(int degrees) {
    const Vec3 line = Vec3(2, 1, -2) / 3;
    return to_data(SO3::exp(pi() * degrees / 180 * line) * to_vec3(standing));
}

/// The least rotation that takes the direction of `a` to that of `b`.
Mat3 least_turn(const Vector3& a, const Vector3& b) {
    const Vec3 from = to_vec3(a), to = to_vec3(b), line = from.cross(to);
    return SO3::exp(atan2(line.norm(), from.dot(to)) * line.normalized());
}

BodyData sphere(const char* name, const Vector3& x) {
    return {.name = name, .mass = 2, .inertia = {1, 0, 0, 0, 1, 0, 0, 0, 1}, .x = x};
}

Model projected(const std::vector<BodyData>& bodies, const std::vector<JointData>& joints) {
    ParameterValues values = default_parameters(problem("multibody").description);
    values["bodies"] = bodies, values["joints"] = joints, values["project_initial"] = true;
    values["gravity"] = Vector3{0, 0, 0};
    return problem("multibody").build(Parameters(values));
}

JointData between_axes(JointData joint, const Vector3& tilted) {
    joint.between = {"ground", "ball"}, joint.points = {origin, origin}, joint.axes = {standing, tilted};
    return joint;
}

const MotionData from_here = {.polynomial = {0, 1}};

const std::vector<JointData> directed = {
    {.type = "revolute"},
    {.type = "prismatic"},
    {.type = "revolute", .turn = from_here},
    {.type = "prismatic", .shift = from_here},
    {.type = "cylindrical", .turn = from_here},
    {.type = "cylindrical", .shift = from_here},
    {.type = "cylindrical", .turn = from_here, .shift = from_here},
    {.type = "screw", .lead = 0.25},
};

}  // namespace

TEST_CASE("axes of every directed joint come together by the angle between them", "[problems]") {
    for (const int degrees : {80, 90, 100, 150, 179}) {
        const Vector3 tilted = apart_by(degrees);
        const Mat3 turn = least_turn(tilted, standing);
        for (const JointData& joint : directed) {
            INFO(joint.type << (joint.turn ? " turn" : "") << (joint.shift ? " shift" : "") << " " << degrees);
            const Model model = projected({sphere("ball", origin)}, {between_axes(joint, tilted)});
            const BodyState& start = model.bodies[0].start;
            CHECK((start.R - turn).norm() <= 100000 * epsilon);
            CHECK(start.x.norm() <= 100000 * epsilon);
            const Vec3 axis = to_vec3(standing).normalized();
            CHECK((start.v - (joint.shift ? axis : Vec3(Vec3::Zero()))).norm() <= 100000 * epsilon);
            CHECK((start.R * start.omega - (joint.turn ? axis : Vec3(Vec3::Zero()))).norm() <= 100000 * epsilon);
        }
    }
}

TEST_CASE("which way opposite axes should turn is not determined, of driven joints as of others", "[problems]") {
    const Vector3 opposite = {-1, -2, -2};
    for (const JointData& joint : directed) {
        INFO(joint.type);
        CHECK_THROWS_WITH(projected({sphere("ball", origin)}, {between_axes(joint, opposite)}),
                          Catch::Contains("axes less than 180 degrees apart, got opposite ones"));
    }
}

TEST_CASE("a wheel that is turned onto its axis meshes where it stands then", "[problems]") {
    const Vector3 centre = to_data(Vec3(2, -2, 1));  // across the standing axis
    for (const int degrees : {80, 100, 150, 179})
        for (const bool first : {true, false}) {
            INFO(degrees << " " << first);
            const Vector3 tilted = apart_by(degrees);
            const auto on_its_axis = [&](const char* name, const Vector3& point, const Vector3& axis) {
                return JointData{.type = "revolute",
                                 .between = {"ground", name},
                                 .points = {point, point},
                                 .axes = {standing, axis}};
            };
            const Vector3 &one = first ? tilted : standing, &two = first ? standing : tilted;
            const Model model =
                projected({sphere("one", origin), sphere("two", centre)}, {on_its_axis("one", origin, one),
                                                                           on_its_axis("two", centre, two),
                                                                           {.type = "gear",
                                                                            .between = {"one", "two"},
                                                                            .points = {origin, centre},
                                                                            .axes = {one, two},
                                                                            .teeth = {17, 30}}});
            CHECK((model.bodies[first ? 0 : 1].start.R - least_turn(tilted, standing)).norm() <= 100000 * epsilon);
            CHECK((model.bodies[first ? 1 : 0].start.R - Mat3::Identity()).norm() <= 100000 * epsilon);
        }
}

TEST_CASE("a pinion that is turned onto its axis meshes with its rack where it stands then", "[problems]") {
    const Vector3 along = {1, 0, 0}, axis = {0, 1, 0}, tilted = {1, 5, 0}, above = {0.03, 0, 0.1};
    const Model model = projected(
        {sphere("rack", above), sphere("pinion", origin)},
        {{.type = "prismatic", .between = {"ground", "rack"}, .points = {above, above}, .axes = {along, along}},
         {.type = "revolute", .between = {"ground", "pinion"}, .points = {origin, origin}, .axes = {axis, tilted}},
         {.type = "rack", .between = {"rack", "pinion"}, .points = {above, origin}, .axes = {along, tilted}}});
    CHECK((model.bodies[1].start.R - least_turn(tilted, axis)).norm() <= 100000 * epsilon);
    CHECK((model.bodies[0].start.x - to_vec3(above)).norm() <= 100000 * epsilon);
}

}  // namespace directed_axes
