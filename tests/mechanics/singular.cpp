// SPDX-License-Identifier: BSD-3-Clause
//
// Singular configurations, contradictory constraints, inconsistent starts and impossible data: none gives numbers
// as if it were regular. Either the start is refused with the joints named, or the first solve reports it.
#include <algorithm>

#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/start.hpp"
#include "mechanics/start_warnings.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

/// Why starting from here and solving once fails: a refusal, a status, or nothing.
std::string complaint(Model model, bool project = false) {
    try {
        if (project) project_start(model);
        check_start(model);
    } catch (const ParameterError& error) { return error.what(); }
    const auto s = make_system(model, "SE3");
    const auto y = initial_state(*s, model);
    VecX a(s->velocities());
    const Status status = s->accelerations(0, y.data(), s->v(y.data()), a.data(), nullptr);
    return status == Status::ok ? "" : std::string(name(status)) + ": " + s->reason(status);
}

Model grounded(JointType type) {
    Model model = bodies_in_a_row(1);
    join(model, ground, 0, type, Vec3(1, -1, 2) / 3);
    model.gravity.g = Vec3(1, -2, -9);
    project_start(model);
    return model;
}

/// A rod of fixed length beside one whose length is driven, between the same points.
Model driven_against_fixed() {
    Model model = grounded("distance");
    model.joints.push_back(model.joints[0]);
    model.joints[1].amplitude = 1, model.joints[1].frequency = 2;
    return model;
}

/// A parallelogram of hinges along z with its ground pivots at 0 and 2, cranks of 1 at `angle` to the line of the
/// pivots, turning at `speed`. At angle 0 all bars lie in that line, a bifurcation with two branches.
Model parallelogram(const Real& angle, const Real& speed) {
    const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ(), u(cos(angle), sin(angle), 0), w = speed * z;
    Model model = bodies_in_a_row(3);
    const Mat3 turned = SO3::exp(angle * z);
    model.bodies[0].start = {u / 2, turned, w.cross(u) / 2, w};
    model.bodies[1].start = {u + x, Mat3::Identity(), w.cross(u), Vec3::Zero()};
    model.bodies[2].start = {2 * x + u / 2, turned, w.cross(u) / 2, w};
    const Vec3 corners[] = {Vec3::Zero(), u, 2 * x + u, 2 * x};
    for (int i = 0; i < 4; ++i) model.join(i == 0 ? ground : i - 1, i == 3 ? ground : i, corners[i], "revolute", z);
    model.gravity.g = Vec3(0, -10, 0);
    return model;
}

/// The system of one model, asked at the start of another.
Status ask(System& s, const Model& elsewhere) {
    const auto y = initial_state(s, elsewhere);
    VecX a(s.velocities());
    return s.accelerations(0, y.data(), s.v(y.data()), a.data(), nullptr);
}

}  // namespace

TEST_CASE("a start off its joints names each joint with its residual", "[singular]") {
    for (const JointType type : joint_types()) {
        INFO(type.name());
        Model position = grounded(type), velocity = position;
        Joint& joint = position.joints[0];
        joint.length += Real(1) / 10, joint.r_second += Vec3(1, 2, -1) / 50;
        joint.axes_second = joint.axes_second * SO3::exp(Vec3(1, -1, 2) / 20);
        CHECK_THAT(complaint(position), Catch::Contains("at position level") &&
                                            Catch::Contains("joint 0 (ground - b0, " + std::string(type.name()) + ")"));
        velocity.bodies[0].start.v += Vec3(1, 2, 3) / 100, velocity.bodies[0].start.omega += Vec3(1, -2, 1) / 100;
        CHECK_THAT(complaint(velocity),
                   Catch::Contains("at velocity level") && Catch::Contains("joint 0 (ground - b0"));
        CHECK(complaint(position, true) == "");
        CHECK(complaint(velocity, true) == "");
    }
}

TEST_CASE("constraints that contradict each other are refused", "[singular]") {
    CHECK_THAT(complaint(driven_against_fixed()), Catch::Contains("joint"));
    for (const JointType type : joint_types()) {
        INFO(type.name());
        Model apart = grounded(type);  // twice the same joint, a little apart: no projection can satisfy both
        apart.joints.push_back(apart.joints[0]);
        apart.joints[1].r_first += Vec3(1, -2, 3) / 4, apart.joints[1].length += 1;
        apart.joints[1].axes_first = SO3::exp(Vec3(3, -2, 1) / 4) * apart.joints[1].axes_first;
        CHECK_THAT(complaint(apart), Catch::Contains("at position level"));
    }
}

TEST_CASE("rods that cannot reach are refused after every attempt to project", "[singular]") {
    Model model = bodies_in_a_row(1);
    for (const int side : {-1, 1})
        model.joints.push_back({.r_first = Vec3(5 * side, 0, 0), .type = "distance", .length = 1});
    CHECK_THAT(complaint(model, true), Catch::Contains("at position level"));
    model.joints[0].type = model.joints[1].type = "spherical";
    CHECK_THAT(complaint(model, true), Catch::Contains("at position level"));
}

TEST_CASE("a start in a singular position: a row dropped there is missing elsewhere", "[singular]") {
    for (const std::string formulation : {"SO3xR3", "SE3", "S3xR3"})
        for (const Real& speed : {Real(0), Real(1), Real(-3)}) {
            INFO(formulation << " at " << to_double(speed));
            const auto s = make_system(parallelogram(0, speed), formulation);
            CHECK(s->constraint_rank().rank == 16);  // 17 in general position
            for (const Real& angle : {Real(1) / 4, Real(-2)}) {
                CHECK(ask(*s, parallelogram(angle, speed)) == Status::singular_kkt);
                CHECK_THAT(s->reason(Status::singular_kkt),
                           Catch::Contains("followed from others at the start") && Catch::Contains("joint"));
            }
        }
}

TEST_CASE("a disk that lies flat has no contact point", "[singular]") {
    Model model = bodies_in_a_row(1);
    model.bodies[0].start = {Vec3::Zero(), Mat3::Identity(), Vec3::Zero(), Vec3(0, 0, 1)};
    model.joints.push_back({.type = "rolling", .length = 1});
    CHECK_FALSE(complaint(model).empty());
}

TEST_CASE("a rod whose points meet has no direction", "[singular]") {
    Model model = bodies_in_a_row(1);
    model.joints.push_back({.r_first = model.bodies[0].start.x, .type = "distance", .length = 0});
    CHECK_FALSE(complaint(model).empty());
}

TEST_CASE("a spring whose points meet pulls nowhere", "[singular]") {
    Model model = bodies_in_a_row(1);
    model.springs.push_back({ground, 0, model.bodies[0].start.x, Vec3::Zero(), 1, 0, 1});
    CHECK_THAT(complaint(model), Catch::Contains("non_finite"));
    model.springs[0].length = 0;
    CHECK(complaint(model) == "");
}

TEST_CASE("rank that is lost along the motion ends a solve, and the joints are named", "[singular]") {
    for (const std::string formulation : {"SO3xR3", "SE3", "S3xR3"})
        for (const Real& angle : {Real(1), Real(-1) / 3, Real(2)}) {
            INFO(formulation << " from " << to_double(angle));
            const auto s = make_system(parallelogram(angle, 1), formulation);
            CHECK(s->constraint_rank().rank == 17);
            CHECK(ask(*s, parallelogram(angle / 2, 2)) == Status::ok);
            CHECK(ask(*s, parallelogram(0, 1)) == Status::singular_kkt);
            CHECK_THAT(s->reason(Status::singular_kkt),
                       Catch::Contains("rank 16") && Catch::Contains("17 at the start") && Catch::Contains("joint"));
            CHECK(ask(*s, parallelogram(angle, 1)) == Status::ok);  // and the next solve works as before
        }
}

TEST_CASE("a torsion spring whose axes may part gives a warning", "[singular]") {
    const auto with_spring = [](Model model, int first, int second, const Vec3& axis) {
        const Mat3 axes = axes_about(axis);
        model.torsion_springs.push_back({first, second, model.axes_of(first, axes), model.axes_of(second, axes), 1});
        const std::vector<std::string> warnings = start_warnings(model);
        return std::count_if(warnings.begin(), warnings.end(), [](const std::string& warning) {
            return warning.starts_with("torsion spring 0") && warning.ends_with("a turn is not defined");
        });
    };
    const Model flat = parallelogram(1, 1);
    CHECK(with_spring(flat, 0, 1, Vec3::UnitZ()) == 0);
    CHECK(with_spring(flat, 0, 2, Vec3::UnitZ()) == 0);  // through two joints about parallel axes
    CHECK(with_spring(flat, ground, 1, Vec3(0, 0, -1)) == 0);
    CHECK(with_spring(flat, 0, 1, Vec3::UnitX()) == 1);
    for (const JointType type : {"fixed", "prismatic"}) CHECK(with_spring(jointed(type), 0, 1, Vec3(1, 2, 3)) == 0);
    for (const JointType type : {"spherical", "universal", "distance"})
        CHECK(with_spring(jointed(type), 0, 1, Vec3::UnitZ()) == 1);
    Model free = bodies_in_a_row(1);
    CHECK(with_spring(free, ground, 0, Vec3::UnitZ()) == 1);
}

TEST_CASE("a start in a singular position or of extreme masses is warned of, with numbers, and no other is",
          "[singular]") {
    const auto warnings = [](const Model& model) {
        for (const std::string& warning : start_warnings(model))
            if (!warning.starts_with("torsion spring")) return warning;
        return std::string();
    };
    for (const Real& size : {Real(1), Real(1) / 1000000}) {
        for (const Real& angle : {Real(0), Real(1) / 4, Real(-2)}) {
            INFO(to_double(angle) << " rad, " << to_double(size) << " m");
            Model model = parallelogram(angle, 1);
            for (Body& body : model.bodies) body.start.x *= size, body.start.v *= size, body.J *= size * size;
            for (Joint& joint : model.joints) joint.r_first *= size, joint.r_second *= size;
            const std::string warning = warnings(model);
            if (angle == 0) CHECK_THAT(warning, Catch::Contains("is 16 there and 17 beside it"));
            if (angle != 0) CHECK(warning == "");
        }
    }
    for (const Named& named : all()) {
        INFO(named.name);
        CHECK(warnings(named.model) == "");
    }
    Model model = jointed("revolute");
    const Real ratio = 1 / (epsilon * 1000);  // three digits are left
    model.bodies[2].mass *= ratio, model.bodies[2].J *= ratio;
    CHECK_THAT(warnings(model), Catch::Contains("nearly dependent") && Catch::Contains("have a ratio of") &&
                                    Catch::Contains("\"b1\" and \"b2\""));
    model.bodies[2].mass /= ratio, model.bodies[2].J /= ratio;
    model.bodies[0].mass *= ratio, model.bodies[0].J *= ratio;  // a light body on a heavy one is harmless
    CHECK(warnings(model) == "");
}
