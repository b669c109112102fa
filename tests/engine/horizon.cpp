// SPDX-License-Identifier: BSD-3-Clause
//
// The error and the horizon that a reference carries: correct for chaos, on the separatrix where the exact motion is
// known, for time reversal, and where the equations fail.
#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>

#include "engine/reference/taylor/taylor_route.hpp"
#include "mechanics/free_body/free_rotation.hpp"
#include "tests/engine/named_problem.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

/// On its separatrix: every error grows like exp(0.42 t) until the body tumbles at a wrong moment.
Model separatrix() {
    Body body;
    body.J = Vec3(1, 2, Real(9) / 4).asDiagonal();
    body.start.omega = Vec3(3, 2, 4) / 4;
    Model model;
    model.bodies.push_back(body);
    return model;
}

Real error(const Model& model, const ReferenceSolution& solution, const Real& t) {
    const Body& body = model.bodies[0];
    return (solution.states[0].omega - free_rotation(body.J, body.start.R, body.start.omega, t).omega).norm();
}

}  // namespace

TEST_CASE("the default double pendulum is chaotic, and in quad both routes still agree at 20 s") {
    const Model model = standard_model("double_pendulum");
    const ReferenceSolution near = confirmed_reference(model, Real(1)), far = confirmed_reference(model, Real(20));
    REQUIRE(near.stopped.empty());
    REQUIRE(far.stopped.empty());
    CHECK(near.horizon == 1);
    CHECK(near.rotation_error < Real("1e-25"));
    CHECK(far.horizon == 20);
    CHECK(far.rotation_error < Real("1e-13"));
    CHECK(far.rotation_error > 1000000 * near.rotation_error);
    CHECK(far.position_error < Real("1e-13"));
}

TEST_CASE("the stated error is the true one, while instability magnifies it a billion times") {
    const Model model = separatrix();
    for (const int t : {1, 25, 50}) {
        CAPTURE(t);
        const ReferenceSolution solution = reference_solution(model, Real(t));
        CHECK(error(model, solution, Real(t)) < 20 * solution.omega_error + Real("1e-30"));
        CHECK(solution.horizon == t);
    }
}

TEST_CASE("past the horizon the reference is wrong, and up to it right") {
    const Model model = separatrix();
    const Real end = 200;
    const ReferenceSolution beyond = reference_solution(model, end);
    CAPTURE(to_double(beyond.horizon));
    CHECK(beyond.horizon > 60);
    CHECK(beyond.horizon < 150);
    CHECK(error(model, beyond, end) > Real("1e-6"));
    CHECK(beyond.omega_error > Real("1e-6"));
    const ReferenceSolution both = confirmed_reference(model, end);
    CHECK(both.horizon <= beyond.horizon);
    CHECK(both.compared);
    CHECK(both.omega_error >= beyond.omega_error);
    CHECK(error(model, both, end) < 100 * both.omega_error);  // errors measured there are above that
    const ReferenceSolution within = reference_solution(model, beyond.horizon);
    CHECK(error(model, within, beyond.horizon) < Real("1e-10"));
}

TEST_CASE("time may run backwards: there and back again") {
    Model model = standard_model("heavy_top");
    const BodyState start = model.bodies[0].start;
    const Real t = Real(1) / 10;
    model.bodies[0].start = reference_solution(model, t).states[0];
    const ReferenceSolution back = reference_solution(model, -t);
    CHECK(back.horizon == -t);
    CHECK((back.states[0].x - start.x).norm() < Real("1e-26"));
    CHECK((back.states[0].R - start.R).norm() < Real("1e-26"));
    CHECK((back.states[0].omega - start.omega).norm() < Real("1e-25"));
}

TEST_CASE("at rest in weightlessness nothing happens, exactly") {
    Model model;
    model.bodies.emplace_back();
    const ReferenceSolution solution = reference_solution(model, Real(3));
    CHECK(solution.horizon == 3);
    CHECK(solution.states[0].x == Vec3(0, 0, 0));
    CHECK(solution.states[0].R == Mat3::Identity());
    CHECK(solution.position_error == 0);
    CHECK(solution.rotation_error == 0);
}

TEST_CASE("where the equations fail there is no state, but the reason") {
    Model model = standard_model("heavy_top");
    SECTION("gravity is not a number") {
        model.gravity.g[2] = std::numeric_limits<Real>::quiet_NaN();
        CHECK(reference_solution(model, Real(1)).stopped == "non_finite");
    }
    SECTION("two rods between the same points, one of them driven") {
        model.joints.push_back({.r_first = Vec3(0, -1, 0), .type = "distance", .length = 2});
        model.joints.push_back(model.joints.back());
        model.joints.back().amplitude = 1, model.joints.back().frequency = 1;
        CHECK(reference_solution(model, Real(1)).stopped == "singular_kkt");
    }
    const ReferenceSolution solution = reference_solution(model, Real(1));
    CHECK(solution.states.empty() == !solution.stopped.empty());
    CHECK(solution.multipliers.empty() == !solution.stopped.empty());
    CHECK((solution.stopped.empty() || solution.horizon == 0));
    CHECK_THROWS_AS(reference_solution(model, std::numeric_limits<Real>::infinity()), std::invalid_argument);
}

TEST_CASE("the same joint twice changes no state, but multipliers are not unique") {
    Model model = standard_model("heavy_top");
    const ReferenceSolution once = reference_solution(model, Real(1) / 8);
    model.joints.push_back(model.joints[0]);
    const ReferenceSolution twice = reference_solution(model, Real(1) / 8);
    CHECK(twice.stopped.empty());
    CHECK(twice.multipliers.empty());
    CHECK((twice.states[0].x - once.states[0].x).norm() < Real("1e-27"));
}

TEST_CASE("a reference that is asked to stop is given up") {
    std::stop_source source;
    source.request_stop();
    const ReferenceSolution solution = reference_solution(standard_model("heavy_top"), Real(1000), source.get_token());
    CHECK(solution.interrupted);
    CHECK(solution.states.empty());
}
