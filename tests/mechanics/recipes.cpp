// SPDX-License-Identifier: BSD-3-Clause
//
// Every joint has what its recipe says: rows that are independent where it holds, and motions that they leave free, in
// number 6 less the rows.
#include <Eigen/QR>

#include "mechanics/joints/joint_rows.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

const Real near_zero = Real(1) / (1L << 30);

/// Two bodies that a joint holds, its points apart as far as it lets them.
Model held_by(const JointKind& kind) {
    if (kind.has(Primitive::contact)) return rolling();
    Model model = bodies_in_a_row(2);
    join(model, 0, 1, JointType(kind), Vec3(1, 2, 0) / 3);
    BodyState& moved = model.bodies[1].start;
    moved.x += Vec3(1, -2, 2) / 16, moved.R = SO3::exp(Vec3(2, 1, -1) / 32) * moved.R;
    project_start(model);
    return model;
}

/// One side of a joint, in space axes.
struct JointSide {
    Motion pose;
    Vec3 point, axis;
    Real lead;
};

JointSide side_of(const Model& model, int body, const Vec3& r, const Mat3& axes, const Real& lead) {
    Motion pose;
    if (body != ground)
        pose.x = model.bodies[std::size_t(body)].start.x, pose.R = model.bodies[std::size_t(body)].start.R;
    return {pose, pose.point(r), pose.direction(axes.col(2)), lead};
}

/// A velocity of a body: v at a point, and omega.
struct Twist {
    Vec3 point, v, omega;
    Vec6 in_axes_of(const Motion& body) const {
        Vec6 both;
        both << body.R.transpose() * (v + omega.cross(body.x - point)), body.R.transpose() * omega;
        return both;
    }
};

/// Velocities of one body, the other at rest, that a free motion stands for; none of those about no line.
std::vector<Twist> twists_of(FreeMotion motion, const JointSide& held) {
    const Vec3 zero = Vec3::Zero();
    const Mat3 axes = axes_about(held.axis);
    switch (motion) {
        case FreeMotion::turn_about_point:
            return {{held.point, zero, Vec3::UnitX()},
                    {held.point, zero, Vec3::UnitY()},
                    {held.point, zero, Vec3::UnitZ()}};
        case FreeMotion::turn_about_axis:
        case FreeMotion::turn_about_two:
            return {{held.point, zero, held.axis}};
        case FreeMotion::turn_about_normal:
            return {{Vec3(1, 2, 3), zero, held.axis}};
        case FreeMotion::slide_along_axis:
            return {{zero, held.axis, zero}};
        case FreeMotion::slide_across_axis:
            return {{zero, axes.col(0), zero}, {zero, axes.col(1), zero}};
        case FreeMotion::screw:
            return {{held.point, held.lead / (2 * pi()) * held.axis, held.axis}};
        case FreeMotion::swing:
        case FreeMotion::roll:
        case FreeMotion::mesh:
            break;
    }
    return {};
}

/// Why the rows of a joint do not leave free what its recipe declares; empty: they do.
std::string objection_to(const JointKind& kind) {
    if (const std::string fault = fault_of(kind); !fault.empty()) return fault;
    const Model model = held_by(kind);
    const Joint& joint = model.joints[0];
    const JointSide first = side_of(model, joint.first, joint.r_first, joint.axes_first, joint.lead),
                    second = side_of(model, joint.second, joint.r_second, joint.axes_second, joint.lead);
    JointRows rows;
    write_rows(joint, 0, first.pose, second.pose, rows);
    if (rows.count != kind.row_count) return "number of rows";
    if (!(rows.phi.head(rows.count).lpNorm<Eigen::Infinity>() < near_zero)) return "it does not hold at the start";
    Eigen::ColPivHouseholderQR<MatX> qr;
    qr.setThreshold(near_zero);
    if (qr.compute(MatX(rows.second.leftCols(rows.count))).rank() != rows.count) return "its rows are not independent";
    const auto stopped = [&](const Mat6& columns, const Twist& twist, const Motion& body) {
        return (columns.leftCols(rows.count).transpose() * twist.in_axes_of(body)).norm() > near_zero;
    };
    for (const FreeMotion motion : kind.free) {
        for (const Twist& twist : twists_of(motion, first))
            if (stopped(rows.second, twist, second.pose)) return "its rows stop a declared motion";
        for (const Twist& twist : twists_of(motion, second))
            if (stopped(rows.first, twist, first.pose)) return "its rows stop a declared motion";
    }
    return "";
}

std::string objection_to(std::vector<JointRow> rows, std::vector<FreeMotion> free) {
    return objection_to(JointKind({.name = "wrong", .summary = "", .rows = std::move(rows), .free = std::move(free)}));
}

}  // namespace

TEST_CASE("rows of every joint are independent and leave free what its recipe says", "[recipes]") {
    for (const JointKind& kind : joint_kinds()) {
        INFO(kind.name);
        CHECK(objection_to(kind) == "");
    }
    CHECK(joint_kinds().size() >= 12);
}

TEST_CASE("rows of every driven joint are independent and leave free what is not prescribed", "[recipes][driven]") {
    for (const JointKind& kind : driven_kinds()) {
        INFO(kind.name);
        CHECK(objection_to(kind) == "");
        CHECK(kind.element.name == kind.name.substr(0, kind.name.find(' ')));
    }
    CHECK(driven_kinds().size() == 5);
    CHECK(driven("cylindrical", {.turn = true, .shift = true})->name == "cylindrical with driven turn and shift");
    CHECK(driven("revolute", {}) == JointType("revolute"));
    CHECK_THROWS_WITH(driven("revolute", {.shift = true}), "no joint \"revolute with driven shift\"");
}

TEST_CASE("a wrong recipe of a joint is seen", "[recipes][control]") {
    using Free = FreeMotion;
    CHECK(objection_to({along(1), along(2), orthogonal(3, 1), orthogonal(3, 1)},
                       {Free::turn_about_axis, Free::slide_along_axis}) == "its rows are not independent");
    CHECK(objection_to({along(1), along(2), orthogonal(3, 1), orthogonal(1, 2)},
                       {Free::turn_about_axis, Free::slide_along_axis}) == "its rows stop a declared motion");
    CHECK(objection_to({along(1), along(3), orthogonal(3, 1), orthogonal(3, 2)},
                       {Free::turn_about_axis, Free::slide_along_axis}) == "its rows stop a declared motion");
    CHECK(objection_to({along(3)}, {Free::turn_about_point, Free::slide_across_axis}) ==
          "its rows stop a declared motion");
    CHECK(objection_to({coincidence()}, {Free::turn_about_axis}) ==
          "expected rows and free motions that add up to 6, got 3 and 1");
    CHECK(objection_to({orthogonal(3, 3), coincidence()}, {Free::turn_about_two}) ==
          "expected the rows on the points before those that compare directions");
    CHECK(objection_to({coincidence(), along(1)}, {Free::turn_about_two}) ==
          "expected rows on the points of one primitive");
    CHECK(objection_to({along(1), along(2), orthogonal(3, 1), orthogonal(3, 2), orthogonal(1, 2)}, {Free::screw}) ==
          "its rows stop a declared motion");
    CHECK(objection_to({coincidence(), shift()}, {Free::turn_about_two}) ==
          "expected rows on the points of one primitive");
    CHECK(objection_to({orthogonal(4, 1)}, {}) == "axes are numbered 1, 2, 3");
    CHECK(objection_to({contact()}, {Free::roll}) == "a contact, and nothing else, has axes that are not parallel");
}

TEST_CASE("a joint that does not exist is refused by a list of those that do", "[recipes]") {
    CHECK_THROWS_WITH(JointType("hinge"), Catch::StartsWith("no joint \"hinge\"; there are spherical, revolute, "));
    CHECK(JointType("revolute") == Joint{.type = "revolute"}.type);
    CHECK(JointType("revolute") != JointType("planar"));
}
