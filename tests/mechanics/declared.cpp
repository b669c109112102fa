// SPDX-License-Identifier: BSD-3-Clause
//
// Which first integrals a model declares. That the declared ones are constant is checked in tests/problems, which
// does not notice a missing one.
#include <array>
#include <set>
#include <utility>

#include "mechanics/integrals.hpp"
#include "mechanics/model/symmetries.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

using Names = std::set<std::string>;

Names declared(const Model& model) {
    Names names;
    for (const FirstIntegral& integral : first_integrals(model)) names.insert(integral.name);
    return names;
}

const Names of_gravity = {"energy", "angular_momentum_vertical"};

Names with(Names names, const Names& more) {
    names.insert(more.begin(), more.end());
    return names;
}

/// The same joints, springs and frames with the two bodies in the other order.
template <class Element>
void reverse(Element& element) {
    std::swap(element.first, element.second);
    std::swap(element.r_first, element.r_second);
}

/// Kovalevskaya's top with other moments A, B, C about its pivot, where x, y, z are its principal axes.
Model kovalevskaya(const Vec3& moments, const Vec3& lever) {
    Model model = standard("kovalevskaya_top");
    Body& body = model.bodies[0];
    body.J.setZero();
    body.J = Mat3(moments.asDiagonal()) - inertia_about(body, lever);
    model.joints[0].r_second = -lever;
    return model;
}

}  // namespace

TEST_CASE("the integrals that registered problems declare", "[declared]") {
    CHECK(declared(standard("kovalevskaya_top")) == with(of_gravity, {"kovalevskaya"}));
    CHECK(declared(standard("lagrange_top")) == with(of_gravity, {"body_momentum"}));
    CHECK(declared(standard("asymmetric_heavy_top")) == of_gravity);
    CHECK(declared(standard("double_pendulum")) == of_gravity);
    CHECK(declared(standard("spherical_pendulum_chain")) == of_gravity);
    CHECK(declared(standard("rolling_disk")) == Names{"energy"});
    CHECK(declared(standard("flyball_governor")) == Names{"angular_momentum_vertical"});
    CHECK(declared(standard("chain")) ==
          with(of_gravity, {"body_momentum_link1", "body_momentum_link2", "body_momentum_link3", "body_momentum_link4",
                            "body_momentum_link5"}));
    const Names free = {"energy",     "angular_momentum_x", "angular_momentum_y", "angular_momentum_z",
                        "momentum_x", "momentum_y",         "momentum_z"};
    CHECK(declared(standard("free_top")) == with(free, {"body_momentum_norm"}));
    CHECK(declared(standard("satellite_rotor")) == with(free, {"body_momentum_rotor"}));
}

TEST_CASE("a body symmetric about its axis of the least or the largest moment keeps its spin", "[declared]") {
    for (const Real& axial : {Real(1) / 4, Real(3) / 2}) {
        Model model = standard("lagrange_top");
        Body& body = model.bodies[0];
        const Vec3 lever = -model.joints[0].r_second;
        const Vec3 e = lever.normalized();
        body.J = Mat3::Identity() + (axial - 1) * e * e.transpose();
        CHECK(declared(model) == with(of_gravity, {"body_momentum"}));
        const auto integrals = first_integrals(model);
        CHECK(abs(abs(integrals.back().value({std::vector{body.start}})) - axial * abs(e.dot(body.start.omega))) <=
              100 * epsilon * body.start.omega.norm());
        body.J += Mat3(Vec3(1, 2, 3).asDiagonal()) / 1000000000;
        CHECK(declared(model) == of_gravity);
    }
}

TEST_CASE("a top is that of Kovalevskaya where all of its conditions hold", "[declared]") {
    const Names all = with(of_gravity, {"kovalevskaya"});
    const Vec3 x = Vec3::UnitX() / 2;
    CHECK(declared(kovalevskaya(Vec3(1, 1, Real(1) / 2), x)) == all);
    CHECK(declared(kovalevskaya(Vec3(1, 1, Real(1) / 2), Vec3(3, -4, 0) / 10)) == all);
    CHECK(declared(kovalevskaya(Vec3(1, Real(5) / 4, Real(1) / 2), x)) == of_gravity);  // A = 2 C, B is not A
    CHECK(declared(kovalevskaya(Vec3(1, 1, Real(3) / 4), x)) == of_gravity);
    CHECK(declared(kovalevskaya(Vec3(1, 1, Real(1) / 3), x)) == of_gravity);
    CHECK(declared(kovalevskaya(Vec3(1, 1, Real(1) / 2), Vec3(3, 0, 1) / 10)) == of_gravity);  // out of the plane
    CHECK_FALSE(declared(kovalevskaya(Vec3(1, 1, Real(1) / 2), Vec3::Zero())).contains("kovalevskaya"));
}

TEST_CASE("a joint to the ground may name its bodies in either order", "[declared]") {
    for (const char* name : {"heavy_top", "lagrange_top", "kovalevskaya_top", "double_pendulum", "chain"}) {
        INFO(name);
        const Model model = standard(name);
        Model other = model;
        for (Joint& joint : other.joints) reverse(joint);
        CHECK(declared(other) == declared(model));
        std::vector<BodyState> states;
        for (const Body& body : model.bodies) states.push_back(body.start);
        const auto a = first_integrals(model), b = first_integrals(other);
        for (std::size_t i = 0; i < a.size(); ++i) {
            CHECK(a[i].value({states}) == b[i].value({states}));
            CHECK(a[i].size({states}) == b[i].size({states}));
        }
    }
}

TEST_CASE("what acts on the bodies of a chain is found once for each end of a joint and of a force", "[declared]") {
    const auto ends = [](int bodies) {
        std::vector<std::pair<int, int>> links;
        for (int i = 0; i < bodies; ++i) links.emplace_back(i == 0 ? ground : i - 1, i);
        Model model = linked(bodies, links);
        for (const auto& [first, second] : links) model.springs.push_back({.first = first, .second = second});
        for (int i = 0; i < bodies; ++i) model.loads.push_back({.body = i});
        std::array<std::size_t, 2> sum = {0, 0};
        for (const BodyTies& ties : ties_of_bodies(model)) sum[0] += ties.joints.size(), sum[1] += ties.centres.size();
        return sum;
    };
    CHECK(ends(8) == std::array<std::size_t, 2>{15, 23});
    CHECK(ends(64) == std::array<std::size_t, 2>{127, 191});
}

TEST_CASE("a force that passes beside the axis of a body takes its spin, one on another body does not", "[declared]") {
    Model model = standard("chain");
    const auto keeps = [&](const std::string& body) { return declared(model).contains("body_momentum_" + body); };
    REQUIRE(model.bodies.size() == 5);
    model.springs.push_back({.first = ground, .second = 1, .stiffness = 1, .length = 1});
    CHECK(keeps("link2"));
    model.springs[0].r_second = Vec3(1, 2, 3);
    CHECK_FALSE(keeps("link2"));
    CHECK(keeps("link1"));
    CHECK(keeps("link3"));
}

TEST_CASE("the size of an angular momentum is the sum of the sizes of its terms", "[declared]") {
    Model model = linked(2, {{ground, 0}, {0, 1}});
    std::vector<BodyState> states;
    Real expected = 0;
    for (const Body& body : model.bodies) {
        states.push_back(body.start);
        expected += (body.start.x - model.joints[0].r_first).norm() * body.mass * body.start.v.norm() +
                    (body.J * body.start.omega).norm();
    }
    const auto integrals = first_integrals(model);
    REQUIRE(integrals.size() == 1);  // gravity varies in time
    CHECK(integrals[0].name == "angular_momentum_vertical");
    CHECK(abs(integrals[0].size({states}) - expected) <= 100 * epsilon * expected);
}
