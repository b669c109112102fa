// SPDX-License-Identifier: BSD-3-Clause
//
// The literature's fast top (omega_z = -4.61538 as a decimal number) against values on which two other programs agree
// to 22 digits, and against its exact invariants.
#include <catch2/catch.hpp>

#include "engine/reference/reference.hpp"
#include "lie/so3.hpp"
#include "tests/engine/named_problem.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

struct Published {
    const char *t, *x[3], *omega[3];
};
const Published published[] = {
    {"0.1",
     {"0.4212966589254020436", "0.8945719743455929909", "-0.1491647005618996116"},
     {"4.808941331728092312", "150", "1.028300756718329842"}},
    {"1",
     {"0.1733439640983860426", "0.6400885920705687829", "-0.7484907911335813095"},
     {"-0.822078101682704456", "150", "-5.923291348117336186"}},
    {"2",
     {"-0.1504168227456417598", "-0.7241655916368956507", "-0.6730222695604440961"},
     {"0.122233219497394237", "150", "-5.855624589205457728"}},
};

Vec3 read(const char* const* text) { return {Real(text[0]), Real(text[1]), Real(text[2])}; }

const Mat3 J = Vec3(Real("0.234375"), Real("0.46875"), Real("0.234375")).asDiagonal();
const Real mass = 15, g = Real("9.81");

}  // namespace

TEST_CASE("the fast heavy top has the published position and angular velocity") {
    const Model model = standard_model("heavy_top");
    for (const Published& value : published) {
        CAPTURE(value.t);
        const ReferenceSolution solution = reference_solution(model, Real(value.t));
        REQUIRE(solution.stopped.empty());
        const BodyState& body = solution.states[0];
        CHECK(solution.horizon == Real(value.t));
        // The last printed digit may be rounded either way; omega prints one digit less.
        CHECK((body.x - read(value.x)).cwiseAbs().maxCoeff() <= Real("1e-19"));
        CHECK((body.omega - read(value.omega)).cwiseAbs().maxCoeff() <= Real("1e-18"));
        for (const Real& error :
             {solution.position_error, solution.rotation_error, solution.velocity_error, solution.omega_error})
            CHECK(error < Real("1e-25"));
        CHECK(solution.multiplier_error.force < Real("1e-23"));
    }
}

TEST_CASE("the fast heavy top keeps spin, vertical momentum, energy and joint") {
    const ReferenceSolution solution = reference_solution(standard_model("heavy_top"), Real(2));
    const BodyState& body = solution.states[0];
    const Real tolerance("1e-24");
    CHECK(abs(body.omega[1] - 150) < tolerance);
    const Real Lz = (body.R * J * body.omega + mass * body.x.cross(body.v))[2];
    CHECK(abs(Lz - Real("-70.3124296875")) < tolerance);
    const Real E = mass * body.v.squaredNorm() / 2 + body.omega.dot(J * body.omega) / 2 + mass * g * body.x[2];
    const Real v0("4.61538"), E0 = mass * v0 * v0 / 2 + (J(1, 1) * 22500 + J(2, 2) * v0 * v0) / 2;
    CHECK(abs(E0 - Real("5435.696790865547")) < Real("1e-12"));
    CHECK(abs(E - E0) < 1000 * tolerance);
    CHECK((body.x - body.R.col(1)).norm() < tolerance);
    CHECK((body.v - body.R * body.omega.cross(Vec3(0, 1, 0))).norm() < tolerance);
    CHECK(SO3::orthogonality_defect(body.R) < 64 * epsilon);
}

TEST_CASE("the multipliers are the joint's force on the body, m (x'' - g)") {
    const ReferenceSolution start = reference_solution(standard_model("heavy_top"), Real(0));
    REQUIRE(start.multipliers.size() == 3);
    CHECK(abs(start.multipliers[0]) < Real("1e-25"));
    CHECK(abs(start.multipliers[1] - Real("-319.525988166")) < Real("1e-9"));
    CHECK(abs(start.multipliers[2] - Real("-317.262461538")) < Real("1e-9"));
}

TEST_CASE("control: another digit in omega, or Euler's equations without gravity, is seen") {
    Model model = standard_model("heavy_top");
    SECTION("-60/13 instead of its truncation") { model.bodies[0].start.omega[2] = Real(-60) / 13; }
    SECTION("no gravity") { model.gravity.g = Vec3::Zero(); }
    const ReferenceSolution solution = reference_solution(model, Real("0.1"));
    CHECK((solution.states[0].x - read(published[0].x)).norm() > Real("1e-10"));
}
