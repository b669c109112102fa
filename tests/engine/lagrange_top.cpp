// SPDX-License-Identifier: BSD-3-Clause
//
// The closed form of the symmetric heavy top, attitude included, and steady precession, against integration by
// extrapolation on quaternions and by Taylor series, which share only the data with it.
#include "problems/lagrange_top_closed_form.hpp"

#include <catch2/catch.hpp>

#include <stdexcept>

#include "engine/reference/taylor/taylor_route.hpp"
#include "engine/report/report.hpp"
#include "lie/so3.hpp"
#include "tests/engine/named_problem.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

/// The literature's top, or one on an oblique lever, in another attitude, in gravity along no axis.
Model top_with(const Mat3& axes, const Mat3& R, const Vec3& omega, const Vec3& gravity) {
    Model model = standard_model("heavy_top");
    Body& body = model.bodies[0];
    const Vec3 lever = axes * Vec3(0, 1, 0);
    body.J = axes * body.J * axes.transpose();
    body.start = {R * lever, R, R * omega.cross(lever), omega};
    model.joints[0].r_second = -lever;
    model.gravity.g = gravity;
    return model;
}

LagrangeTop top_of(const Model& model) {
    return lagrange_top(model.bodies[0], -model.joints[0].r_second, model.gravity.g);
}

TopState start_of(const Model& model) { return {model.bodies[0].start.R, model.bodies[0].start.omega}; }

Real apart(const TopState& a, const BodyState& b) {
    return max(Real(SO3::log(a.R.transpose() * b.R).norm()), Real((a.omega - b.omega).norm()));
}

/// Distance of the closed form from both routes.
Real error(const Model& model, const Real& t) {
    const TopState closed = lagrange_motion(top_of(model), start_of(model), t);
    TaylorRoute route(model);
    REQUIRE(route.advance(t, {}) == Status::ok);
    return max(apart(closed, reference_solution(model, t).states[0]), apart(closed, route.states()[0]));
}

const Vec3 down(0, 0, -Real("9.81"));
const Vec3 slow(0, Real(3) / 2, -Real("0.0461538"));

}  // namespace

TEST_CASE("the closed form of the literature's heavy top agrees with both routes, attitude included") {
    const Model model = standard_model("heavy_top");
    for (const char* t : {"0.1", "1", "2"}) {
        const Real difference = error(model, Real(t));
        CAPTURE(t, to_double(difference));
        CHECK(difference < Real("1e-26"));
    }
}

TEST_CASE("the published position follows from the closed form") {
    const Model model = standard_model("heavy_top");
    const Vec3 x = lagrange_motion(top_of(model), start_of(model), Real(2)).R * Vec3(0, 1, 0);
    const Vec3 published(Real("-0.1504168227456417598"), Real("-0.7241655916368956507"),
                         Real("-0.6730222695604440961"));
    CHECK((x - published).cwiseAbs().maxCoeff() < Real("1e-18"));
}

TEST_CASE("the closed form holds from rising and falling starts, in any axes, forwards and backwards") {
    const Vec3 aslant = SO3::exp(Vec3(1, 2, 0) / 3) * down;
    const Vec3 falling(1, 20, 2), rising(-1, 20, -2), against(1, -20, 2), pendulum(Real(1) / 2, Real(1) / 10, -1);
    for (const Vec3& omega : {slow, falling, rising, against, pendulum})
        for (const int t : {-1, 1, 3}) {
            const Real straight = error(top_with(Mat3::Identity(), oblique, omega, down), Real(t));
            const Real turned = error(top_with(oblique, oblique, oblique * omega, aslant), Real(t));
            CAPTURE(to_double(omega[0]), to_double(omega[1]), t, to_double(straight), to_double(turned));
            CHECK(straight < Real("1e-26"));
            CHECK(turned < Real("1e-26"));
        }
}

TEST_CASE("control: data changed in the twentieth digit are seen") {
    Model model = standard_model("heavy_top");
    const TopState exact = lagrange_motion(top_of(model), start_of(model), Real(1));
    SECTION("inertia about the axis") { model.bodies[0].J(1, 1) += Real("1e-20"); }
    SECTION("gravity") { model.gravity.g[2] += Real("1e-18"); }
    SECTION("a start off its turning point") { model.bodies[0].start.omega[0] += Real("1e-20"); }
    const TopState changed = lagrange_motion(top_of(model), start_of(model), Real(1));
    CHECK((exact.R - changed.R).norm() > Real("1e-24"));
    CHECK((exact.R - changed.R).norm() < Real("1e-16"));
}

TEST_CASE("steady precession, slow and fast, agrees with both routes and with the closed form") {
    for (const Mat3& R : {Mat3(Mat3::Identity()), oblique})
        for (const bool fast : {false, true}) {
            const LagrangeTop top = top_of(standard_model("heavy_top"));
            if (fast && R == Mat3::Identity()) continue;
            const SteadyPrecession steady =
                fast ? fast_precession(top, R, Real(150)) : slow_precession(top, R, Real(150));
            const TopState start = steady_motion(top, steady, R, Real(0)), end = steady_motion(top, steady, R, Real(1));
            CHECK(abs(start.omega[1] - 150) < Real("1e-30"));
            const Model model = top_with(Mat3::Identity(), R, start.omega, down);
            TaylorRoute route(model);
            REQUIRE(route.advance(Real(1), {}) == Status::ok);
            CAPTURE(fast, to_double(steady.precession), to_double(apart(end, route.states()[0])));
            CHECK(apart(end, route.states()[0]) < Real("1e-26"));
            CHECK(apart(end, reference_solution(model, Real(1)).states[0]) < Real("1e-26"));
            const TopState closed = lagrange_motion(top, start, Real(1));
            CHECK((closed.R - end.R).norm() < Real("1e-14"));
        }
}

TEST_CASE("control: a precession that is not steady, or of the wrong sense, is told from the motion") {
    const LagrangeTop top = top_of(standard_model("heavy_top"));
    const SteadyPrecession steady = slow_precession(top, oblique, Real(150));
    for (const Real& factor : {Real(1 + Real("1e-18")), Real(-1)}) {
        const SteadyPrecession wrong = {steady.precession * factor, steady.spin};
        const TopState start = steady_motion(top, wrong, oblique, Real(0));
        const Model model = top_with(Mat3::Identity(), oblique, start.omega, down);
        const BodyState truth = reference_solution(model, Real(1)).states[0];
        CHECK(apart(steady_motion(top, wrong, oblique, Real(1)), truth) > Real("1e-24"));
    }
}

TEST_CASE("tops without the closed form, and motions through the vertical, are refused") {
    const Model forced = standard_model("forced_heavy_top"), model = standard_model("heavy_top");
    CHECK_THROWS_AS(top_of(forced), std::domain_error);
    CHECK_THROWS_AS(lagrange_top(model.bodies[0], Vec3::Zero(), down), std::domain_error);
    CHECK_THROWS_AS(lagrange_top(model.bodies[0], Vec3(0, 1, 0), Vec3::Zero()), std::domain_error);
    const Mat3 upright = SO3::exp(Vec3(pi() / 2, Real(0), Real(0)));
    CHECK_THROWS_AS(lagrange_motion(top_of(model), {upright, Vec3(1, 150, 0)}, Real(1)), std::domain_error);
    const Mat3 tilted = SO3::exp(Vec3(Real(1), Real(0), Real(0)));
    CHECK_THROWS_AS(slow_precession(top_of(model), tilted, Real(1)), std::domain_error);
    CHECK_THROWS_AS(fast_precession(top_of(model), Mat3::Identity(), Real(150)), std::domain_error);
}
