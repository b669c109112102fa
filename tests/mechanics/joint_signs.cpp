// SPDX-License-Identifier: BSD-3-Clause
//
// The signs of NOTATION.md: each row is what the first-named body has minus what the second has, so that a unit
// multiplier of a row along e is the force e on the second body, that of a_i.b_k the torque a_i x b_k, that of a
// distance a tension. Derived here independently, for the two bodies in either order and either of them the ground.
#include <map>

#include "mechanics/joints/joint_rows.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

/// A row as NOTATION.md has it: its residual, and the force and the couple of a unit multiplier on the second body, at
/// a point from its mass centre; all in space axes.
struct SignedRow {
    Real phi;
    Vec3 force, point, couple;
};

struct Ends {
    const Joint& joint;
    Motion first, second;
    Vec3 a(int k) const { return first.R * joint.axes_first.col(k - 1); }
    Vec3 b(int k) const { return second.R * joint.axes_second.col(k - 1); }
    Vec3 p1() const { return first.x + first.R * joint.r_first; }
    Vec3 p2() const { return second.x + second.R * joint.r_second; }
    Vec3 d() const { return p1() - p2(); }
    SignedRow coincide(int k) const { return {d()[k], Vec3::Unit(k), p2() - second.x, Vec3::Zero()}; }
    SignedRow along(int k) const { return {b(k).dot(d()), b(k), p1() - second.x, Vec3::Zero()}; }
    SignedRow compare(int i, int k) const { return {a(i).dot(b(k)), Vec3::Zero(), Vec3::Zero(), a(i).cross(b(k))}; }
    SignedRow distance() const { return {d().norm() - joint.length, d().normalized(), p2() - second.x, Vec3::Zero()}; }
    SignedRow shift() const {
        SignedRow row = along(3);
        row.phi += joint.shift.polynomial[0];
        return row;
    }
    /// a_1 turned by f, and its shadow on the plane across b_3, turned by a quarter and divided by its square: what the
    /// shadow's angle grows with.
    struct Turned {
        Vec3 a, growth;
    };
    Turned turned(const Real& f) const {
        const Vec3 a_f = SO3::exp(f * a(3)) * a(1), shadow = a_f - a_f.dot(b(3)) * b(3);
        return {a_f, b(3).cross(shadow) / shadow.squaredNorm()};
    }
    /// The angle from b_1 to the shadow of a_1(f).
    SignedRow turn(const Real& f) const {
        const auto [a_f, growth] = turned(f);
        return {atan2(a_f.dot(b(2)), a_f.dot(b(1))), Vec3::Zero(), Vec3::Zero(), a_f.cross(growth)};
    }
    SignedRow helix() const {
        const Real radians = -2 * pi() / joint.lead, f = radians * b(3).dot(d());
        const auto [a_f, growth] = turned(f);
        SignedRow row = turn(f);
        row.force = radians * a(3).cross(a_f).dot(growth) * b(3), row.point = p1() - second.x;
        return row;
    }
    /// The pinion is compared with the rack's frame (a_3, -a_2).
    SignedRow rack() const {
        const Real radians = 2 * pi() / joint.lead, f = radians * a(3).dot(d());
        const Vec3 side = -a(2), a_f = cos(f) * a(3) + sin(f) * side, shadow = a_f - a_f.dot(b(3)) * b(3);
        const Vec3 growth = b(3).cross(shadow) / shadow.squaredNorm();
        return {atan2(a_f.dot(b(2)), a_f.dot(b(1))), radians * a(1).cross(a_f).dot(growth) * a(3), p2() - second.x,
                a_f.cross(growth)};
    }
    /// Angles of the line of centres in both wheels; what they grow with is across the line's shadow on their planes.
    /// The part of the first wheel acts at the centre of the second, the other at that of the first.
    SignedRow mesh() const {
        const auto growth = [&](const Vec3& axis) -> Vec3 {
            const Vec3 shadow = d() - d().dot(axis) * axis;
            return axis.cross(shadow) / shadow.squaredNorm();
        };
        const Real z1 = joint.teeth[0], z2 = joint.teeth[1];
        const Real sum = z1 * atan2(a(2).dot(d()), a(1).dot(d())) + z2 * atan2(b(2).dot(d()), b(1).dot(d()));
        const Real turns = sum - 2 * pi() * floor_of(sum / (2 * pi()) + Real(1) / 2);
        const Vec3 of_first = z1 / z2 * growth(a(3)), of_second = growth(b(3));
        return {turns / z2, of_first + of_second, p2() - second.x, d().cross(of_second)};
    }
    static Real floor_of(const Real& x) {
        using std::floor;
        return floor(x);
    }
    SignedRow contact(int k) const {
        const Vec3 down = (a(3).dot(b(3)) * b(3) - a(3)).normalized(), touching = p2() + joint.length * down;
        return {k == 3 ? Real(a(3).dot(p1() - touching)) : Real(0), a(k), touching - second.x, Vec3::Zero()};
    }
};

/// Those of a joint that NOTATION.md does not list: from its recipe.
std::vector<SignedRow> rows_of_recipe(const Ends& e) {
    std::vector<SignedRow> rows;
    for (const JointRow& row : e.joint.type->rows) {
        if (row.primitive == Primitive::coincidence)
            for (int k = 0; k < 3; ++k) rows.push_back(e.coincide(k));
        if (row.primitive == Primitive::along) rows.push_back(e.along(row.k + 1));
        if (row.primitive == Primitive::orthogonal) rows.push_back(e.compare(row.i + 1, row.k + 1));
        if (row.primitive == Primitive::distance) rows.push_back(e.distance());
        if (row.primitive == Primitive::shift) rows.push_back(e.shift());
        if (row.primitive == Primitive::turn) rows.push_back(e.turn(e.joint.turn.polynomial[0]));
        if (row.primitive == Primitive::helix) rows.push_back(e.helix());
        if (row.primitive == Primitive::rack) rows.push_back(e.rack());
        if (row.primitive == Primitive::mesh) rows.push_back(e.mesh());
    }
    return rows;
}

std::vector<SignedRow> rows_of_notation(const Ends& e) {
    const SignedRow x = e.coincide(0), y = e.coincide(1), z = e.coincide(2);
    const std::map<std::string, std::vector<SignedRow>> notation = {
        {"spherical", {x, y, z}},
        {"revolute", {x, y, z, e.compare(3, 1), e.compare(3, 2)}},
        {"universal", {x, y, z, e.compare(3, 3)}},
        {"prismatic", {e.along(1), e.along(2), e.compare(3, 1), e.compare(3, 2), e.compare(1, 2)}},
        {"cylindrical", {e.along(1), e.along(2), e.compare(3, 1), e.compare(3, 2)}},
        {"planar", {e.along(3), e.compare(3, 1), e.compare(3, 2)}},
        {"fixed", {x, y, z, e.compare(3, 1), e.compare(3, 2), e.compare(1, 2)}},
        {"distance", {e.distance()}},
        {"rolling", {e.contact(3), e.contact(1), e.contact(2)}}};
    const auto found = notation.find(e.joint.type.name());
    return found == notation.end() ? rows_of_recipe(e) : found->second;
}

/// The objection to the rows; empty: none.
std::string fault_of(const Ends& ends, const JointRows& rows) {
    const auto expected = rows_of_notation(ends);
    if (static_cast<int>(expected.size()) != rows.count) return "number of rows";
    const Mat3& R = ends.second.R;
    for (int k = 0; k < rows.count; ++k) {
        const SignedRow& row = expected[static_cast<std::size_t>(k)];
        const Vec3 force = R * -rows.second.block<3, 1>(0, k), torque = R * -rows.second.block<3, 1>(3, k);
        const std::string where = " of row " + std::to_string(k + 1);
        if (!(abs(rows.phi[k] - row.phi) <= 1000 * epsilon)) return "residual" + where;
        if (!((force - row.force).norm() <= 1000 * epsilon)) return "force" + where;
        if (!((torque - row.point.cross(row.force) - row.couple).norm() <= 1000 * epsilon)) return "torque" + where;
    }
    return "";
}

/// Poses that violate every joint, so that every residual shows its sign.
Motion displaced(int i) {
    const BodyState pose = asymmetric_body(i).start;
    return {pose.x + Vec3(i, 2, 1) / 7, SO3::exp(Vec3(1, i, -2) / 9) * pose.R};
}

template <class F>
void for_each_order(F f) {
    std::vector<JointType> types = joint_types();
    types.push_back("rolling");
    for (const JointType type : driven_types()) types.push_back(type);
    for (const JointType type : types)
        for (const auto& [first, second] :
             {std::pair(ground, 1), std::pair(1, ground), std::pair(1, 2), std::pair(2, 1)}) {
            if (type == "rolling" && first != ground) continue;
            Joint joint{.first = first,
                        .second = second,
                        .r_first = Vec3(1, -1, 2) / 5,
                        .r_second = Vec3(2, 1, -1) / 3,
                        .type = type,
                        .axes_first = axes_about(Vec3(1, -2, 2)),
                        .axes_second = axes_about(Vec3(3, 1, 1)),
                        .length = Real(3) / 4};
            prescribe(joint);
            if (!joint.turn.is_zero()) joint.turn.polynomial[0] = Real(5) / 2;
            if (!joint.shift.is_zero()) joint.shift.polynomial[0] = Real(1) / 3;
            const auto motion = [](int body) { return body == ground ? Motion() : displaced(body); };
            INFO(type.name() << " between " << first << " and " << second);
            f(Ends{joint, motion(first), motion(second)});
        }
}

}  // namespace

TEST_CASE("rows of every joint have the signs of the notation, the bodies in either order", "[reactions]") {
    int judged = 0;
    for_each_order([&](const Ends& ends) {
        JointRows rows;
        write_rows(ends.joint, 0, ends.first, ends.second, rows);
        CHECK(fault_of(ends, rows) == "");
        ++judged;
    });
    CHECK(judged == 4 * static_cast<int>(joint_types().size() + driven_types().size()) + 1);
}

TEST_CASE("a reversed row of any joint is rejected", "[reactions]") {
    for_each_order([](const Ends& ends) {
        JointRows rows;
        write_rows(ends.joint, 0, ends.first, ends.second, rows);
        for (int k = 0; k < rows.count; ++k) {
            JointRows reversed = rows;
            reversed.phi[k] *= -1, reversed.second.col(k) *= -1, reversed.first.col(k) *= -1;
            CHECK(fault_of(ends, reversed) != "");
            reversed = rows;
            reversed.second.col(k) *= -1;
            CHECK(fault_of(ends, reversed) != "");
        }
    });
}
