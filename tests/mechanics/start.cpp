// SPDX-License-Identifier: BSD-3-Clause
//
// How a start is moved onto its joints: by the least change, and how that is reported.
#include <Eigen/QR>

#include "lie/so3.hpp"
#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/start.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

Model held(JointType type, const Vec3& point) {
    Model model = bodies_in_a_row(1);
    model.bodies[0].start.omega.setZero();
    join(model, ground, 0, type, point);
    return model;
}

/// M and C of SO3xR3 at the start.
struct Rows {
    explicit Rows(const Model& model) {
        const auto s = make_system(model, "SO3xR3");
        const auto y = initial_state(*s, model);
        const int n = s->velocities();
        C.resize(s->constraints(), n), M.setZero(n, n);
        s->jacobian(0, y.data(), C.data());
        std::vector<Real> blocks(static_cast<std::size_t>(6 * n));
        s->mass(y.data(), blocks.data());
        for (int i = 0; i < n; i += 6)
            M.block<6, 6>(i, i) = Eigen::Map<const Mat6>(&blocks[static_cast<std::size_t>(6 * i)]);
    }
    MatX M, C;
};

/// The part of M u outside the range of C^T: zero if u is the least change that makes C (v + u) what it is.
Real not_least(const Rows& rows, const VecX& u) {
    const VecX momentum = rows.M * u;
    const MatX Ct = rows.C.transpose();
    return (momentum - Ct * Ct.completeOrthogonalDecomposition().solve(momentum)).norm() / momentum.norm();
}

}  // namespace

TEST_CASE("a correction of the start is reported by its largest parts", "[start]") {
    const Vec3 d(1, -2, 3), turn(2, -1, 1), v(-1, 4, 2), omega(3, 1, -2);
    Model model = held("fixed", bodies_in_a_row(1).bodies[0].start.x);  // at the mass centre: nothing is coupled
    BodyState& start = model.bodies[0].start;
    const BodyState on_joint = start;
    start.x += d / 1000, start.R *= SO3::exp(turn / 1000), start.v = v / 1000, start.omega = omega / 1000;
    const StartCorrection moved = project_start(model);
    CHECK(abs(moved.position - d.norm() / 1000) <= 100 * epsilon);
    CHECK(abs(moved.rotation - turn.norm() / 1000) <= 100 * epsilon);
    CHECK(abs(moved.velocity - v.norm() / 1000) <= 100 * epsilon);
    CHECK(abs(moved.omega - omega.norm() / 1000) <= 100 * epsilon);
    CHECK((start.x - on_joint.x).norm() + (start.R - on_joint.R).norm() <= 100 * epsilon);
    CHECK(start.v.norm() + start.omega.norm() <= 100 * epsilon);
}

namespace {

/// A sphere on a revolute joint at its centre, whose axis is off that of the ground by an angle about x.
Model tilted(const Real& angle) {
    Model model = held("revolute", Vec3::Zero());
    model.bodies[0].J = Mat3::Identity();
    model.bodies[0].start.x.setZero();
    model.bodies[0].start.R = SO3::exp(angle * Vec3::UnitX());
    model.joints[0].r_second.setZero();
    model.joints[0].axes_first = model.joints[0].axes_second = Mat3::Identity();
    return model;
}

}  // namespace

TEST_CASE("directed axes come to point in one direction, by the angle between them", "[start]") {
    for (const int degrees : {1, 44, 46, 80, 90, 100, 179}) {
        INFO(degrees);
        const Real angle = pi() * degrees / 180;
        for (const Real& signed_angle : {angle, Real(-angle)}) {
            Model model = tilted(signed_angle);
            const StartCorrection moved = project_start(model);
            CHECK(abs(moved.rotation - angle) <= 10000 * epsilon);
            CHECK((model.bodies[0].start.R - Mat3::Identity()).norm() <= 10000 * epsilon);
        }
    }
    Model opposite = tilted(pi());
    CHECK_THROWS_WITH(project_start(opposite),
                      Catch::Contains("joint 0 (ground - ") &&
                          Catch::Contains("axes less than 180 degrees apart, got opposite ones"));
}

TEST_CASE("two bodies share the angle between their axes by their moments of inertia", "[start]") {
    Model model = tilted(0);
    model.bodies.push_back(model.bodies[0]);
    model.bodies[1].name = "second", model.bodies[1].J *= 3;
    model.joints[0].first = 0, model.joints[0].second = 1;
    const Real angle = pi() * 100 / 180;
    model.bodies[1].start.R = SO3::exp(angle * Vec3::UnitY());
    project_start(model);
    CHECK((model.bodies[0].start.R - SO3::exp(angle * 3 / 4 * Vec3::UnitY())).norm() <= 10000 * epsilon);
    CHECK((model.bodies[1].start.R - model.bodies[0].start.R).norm() <= 10000 * epsilon);
}

TEST_CASE("a start on its joints stays where it is", "[start]") {
    for (const JointType type : joint_types()) {
        INFO(type.name());
        Model model = jointed(type);
        const StartCorrection moved = project_start(model);
        CHECK(moved.position + moved.rotation + moved.velocity + moved.omega <= 10000 * epsilon);
    }
}

TEST_CASE("velocities change least in the metric of the masses", "[start]") {
    for (const JointType type : joint_types()) {
        INFO(type.name());
        Model model = jointed(type);
        VecX before(18), after(18);
        for (Eigen::Index i = 0; i < 3; ++i) {
            BodyState& start = model.bodies[static_cast<std::size_t>(i)].start;
            start.v += Vec3(1, Real(i), -2) / 8, start.omega += Vec3(-1, 2, Real(i)) / 8;
            before.segment<6>(6 * i) << start.v, start.omega;
        }
        const Rows rows(model);
        project_start(model);
        for (Eigen::Index i = 0; i < 3; ++i) {
            const BodyState& start = model.bodies[static_cast<std::size_t>(i)].start;
            after.segment<6>(6 * i) << start.v, start.omega;
        }
        CHECK((after - before).norm() > Real(1) / 100);
        CHECK(not_least(rows, after - before) <= 100000 * epsilon);
    }
}

TEST_CASE("a small step of the positions is least in the metric of the masses too", "[start]") {
    const Real small = sqrt(sqrt(epsilon));  // what is left over is of second order
    for (const JointType type : joint_types()) {
        INFO(type.name());
        Model model = jointed(type);
        std::vector<BodyState> before;
        for (Body& body : model.bodies) {
            body.start.x += small * Vec3(1, -2, body.mass), body.start.R *= SO3::exp(small * Vec3(body.mass, 1, 2));
            before.push_back(body.start);
        }
        const Rows rows(model);
        project_start(model);
        VecX u(18);
        for (Eigen::Index i = 0; i < 3; ++i) {
            const BodyState &a = before[static_cast<std::size_t>(i)],
                            &b = model.bodies[static_cast<std::size_t>(i)].start;
            u.segment<6>(6 * i) << b.x - a.x, SO3::log(a.R.transpose() * b.R);
        }
        CHECK(not_least(rows, u) <= 1000 * small);
    }
}

TEST_CASE("a refused start reports the gap of each joint", "[start]") {
    Model model = held("spherical", Vec3(1, -1, 2));
    model.joints[0].r_first += Vec3(3, 0, 4) / 20;
    CHECK_THROWS_WITH(check_start(model), Catch::Contains("at position level") &&
                                              Catch::Contains("joint 0 (ground - b0, spherical): 0.25 m"));
    model = held("fixed", Vec3(1, -1, 2));
    model.bodies[0].start.v = Vec3(0, 0, 2);
    CHECK_THROWS_WITH(check_start(model),
                      Catch::Contains("at velocity level") && Catch::Contains("joint 0 (ground - b0, fixed): 2 m/s"));
    model = held("planar", Vec3(1, -1, 2));
    model.bodies[0].start.omega = model.bodies[0].start.R.transpose() * model.joints[0].axes_first.col(0);
    CHECK_THROWS_WITH(check_start(model), Catch::Contains("and 1 1/s"));
}

TEST_CASE("the scale of a row is the longer of its arms", "[start]") {
    const Model model = bodies_in_a_row(2);
    const Vec3 near(1, 2, 2), far(2, 3, 6);  // 3 and 7 m
    CHECK(row_scale(model, {.first = 0, .second = 1, .r_first = near, .r_second = far}, 0) == 7);
    CHECK(row_scale(model, {.first = 0, .second = 1, .r_first = far, .r_second = near}, 0) == 7);
    CHECK(row_scale(model, {.r_first = far, .r_second = near}, 0) == 3);  // the ground has a place, but no arm
    CHECK(row_scale(model, {.r_first = far, .r_second = near, .type = "revolute"}, 3) == 1);
    CHECK(row_scale(model, {.r_second = near, .type = "distance", .length = 5}, 0) == 5);
}

TEST_CASE("the scale of a row without an arm is that of its bodies, or of the mechanism", "[start]") {
    Model model = bodies_in_a_row(2);
    for (Body& body : model.bodies) body.J = 9 * body.mass * Mat3(Vec3(1, 2, 5).asDiagonal());
    CHECK(row_scale(model, {}, 0) == 6);  // sqrt(9 * 8 / 2)
    model.bodies[0].point = true;
    CHECK(row_scale(model, {.first = 0, .second = 1}, 0) == 6);
    model.bodies[1].point = true;
    model.bodies[0].start.x = Vec3(100, 0, 2), model.bodies[1].start.x = Vec3(100, 12, -3);
    CHECK(row_scale(model, {.first = 0, .second = 1}, 0) == 13);  // from one mass to the other
    model.bodies[1].start.x = model.bodies[0].start.x;
    CHECK(row_scale(model, {.first = 0, .second = 1}, 0) == 1);
}
