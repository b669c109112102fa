// SPDX-License-Identifier: BSD-3-Clause
//
// Every registered problem by two routes: extrapolation on quaternions through System, and Taylor series in rotation
// matrices straight from the model. The coordinates, the family and the code of mass, forces and
// constraints differ.
#include <catch2/catch.hpp>

#include <limits>
#include <stdexcept>

#include "tests/engine/named_problem.hpp"
#include "tests/engine/two_routes.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

/// The acceptance problem with an error in its data.
enum class Fault { none, gravity_phase, inertia, lever };

Model forced_top(Fault fault) {
    Model model = standard_model("forced_heavy_top");
    const Real small("1e-20");
    if (fault == Fault::gravity_phase) model.gravity.frequency += small;
    if (fault == Fault::inertia) model.bodies[0].J(0, 1) += small;
    if (fault == Fault::lever) model.joints[0].r_second[2] += small;
    return model;
}

}  // namespace

/// Tops and pendulums to t = 1, mechanisms, whose first route is slow, to 1/16; the stiff one would need steps of
/// 1e-6 s.
Real end_of(const std::string& name) {
    if (name == "flyball_governor") return Real(1) / 4096;
    for (const char* fast : {"free_top", "heavy_top", "forced_heavy_top", "double_pendulum", "forced_free_body"})
        if (name == fast) return 1;
    return Real(1) / 16;
}

TEST_CASE("two routes agree to 25 digits on every registered problem") {
    for (const Problem& problem : problems()) {
        const Model model = standard_model(problem.description.name);
        const Real t = end_of(problem.description.name);
        INFO(problem.description.name);
        const ReferenceSolution first = reference_solution(model, t);
        REQUIRE(first.stopped.empty());
        const Real difference = relative_difference(first, taylor(model, t));
        CAPTURE(problem.description.name, to_double(difference));
        CHECK(difference < Real("1e-25"));
    }
}

TEST_CASE("control: twenty digits of agreement are not enough to pass") {
    const ReferenceSolution first = reference_solution(forced_top(Fault::none), Real(1));
    for (const Fault fault : {Fault::gravity_phase, Fault::inertia, Fault::lever})
        CHECK(relative_difference(first, taylor(forced_top(fault), Real(1))) > Real("1e-23"));
    CHECK(relative_difference(first, taylor(forced_top(Fault::none), Real(1))) < Real("1e-25"));
}

TEST_CASE("at their horizon the routes agree to 12 digits") {
    const struct {
        const char* name;
        int t;
    } cases[] = {{"free_top", 20}, {"heavy_top", 2}, {"forced_heavy_top", 5}, {"double_pendulum", 5}};
    for (const auto& [name, t] : cases) {
        CAPTURE(name, t);
        const ReferenceSolution both = confirmed_reference(standard_model(name), Real(t));
        INFO(both.route);
        REQUIRE(both.horizon == t);
        CHECK(both.rotation_error < Real("1e-12"));
        CHECK(both.rotation_error > 0);
        CHECK(both.route.find("Taylor series of order 40") != std::string::npos);
    }
}

TEST_CASE("the confirmed horizon is where the routes part, and its error is at least the difference of the routes") {
    Body body;  // on its separatrix
    body.J = Vec3(1, 2, Real(9) / 4).asDiagonal();
    body.start.omega = Vec3(3, 2, 4) / 4;
    Model model;
    model.bodies.push_back(body);
    const ReferenceSolution first = reference_solution(model, Real(200)), both = confirmed_reference(model, Real(200));
    CHECK(both.horizon <= first.horizon);
    CHECK(both.horizon > 60);
    const ReferenceSolution near = confirmed_reference(model, Real(50));
    CHECK(near.horizon == 50);
    // Other steps round differently, and the motion amplifies that.
    CHECK(near.rotation_error >= distance(near.states, taylor(model, Real(50)).states).rotation / 2);
}

TEST_CASE("Taylor series run backwards, stay where nothing happens, and name what fails") {
    SECTION("there and back") {
        Model model = standard_model("double_pendulum");
        const std::vector<BodyState> start = {model.bodies[0].start, model.bodies[1].start};
        const Taylor there = taylor(model, Real(1));
        for (std::size_t i = 0; i < 2; ++i) model.bodies[i].start = there.states[i];
        const Distance d = distance(taylor(model, Real(-1)).states, start);
        CHECK(max(max(d.position, d.rotation), max(d.velocity, d.omega)) < Real("1e-27"));
    }
    SECTION("at rest in weightlessness") {
        Model model;
        model.bodies.emplace_back();
        CHECK(taylor(model, Real(3)).states[0].R == Mat3::Identity());
    }
    SECTION("gravity is not a number") {
        Model model = standard_model("heavy_top");
        model.gravity.g[2] = std::numeric_limits<Real>::quiet_NaN();
        CHECK(TaylorRoute(model).advance(Real(1), {}) == Status::non_finite);
    }
    SECTION("the same joint twice, and a rod beside it whose length contradicts it") {
        Model model = standard_model("heavy_top");
        const Taylor once = taylor(model, Real(1) / 8);
        model.joints.push_back(model.joints[0]);
        const Distance d = distance(taylor(model, Real(1) / 8).states, once.states);
        CHECK(max(max(d.position, d.rotation), max(d.velocity, d.omega)) < Real("1e-27"));
        model.joints[1] = model.joints[0];
        model.joints[1].type = "distance";
        model.joints[1].r_first -= Vec3::UnitX();
        model.joints[1].length = 1, model.joints[1].amplitude = Real(1) / 4, model.joints[1].frequency = 1;
        model.joints.push_back(model.joints[0]);
        CHECK(TaylorRoute(model).advance(Real(1), {}) == Status::singular_kkt);
    }
    SECTION("an order without room for an error estimate") {
        CHECK_THROWS_AS(TaylorSeries(standard_model("heavy_top"), 1), std::invalid_argument);
    }
    SECTION("a stop request") {
        std::stop_source source;
        source.request_stop();
        CHECK(confirmed_reference(standard_model("heavy_top"), Real(1000), source.get_token()).interrupted);
    }
}
