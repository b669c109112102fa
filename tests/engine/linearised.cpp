// SPDX-License-Identifier: BSD-3-Clause
//
// Motions linearised about equilibria and steady motions, against published eigenvalues and closed forms.
#include "engine/linearised/linearise.hpp"

#include <catch2/catch.hpp>

#include "engine/linearised/spectrum.hpp"
#include "engine/report/report.hpp"
#include "problems/lagrange_top_closed_form.hpp"
#include "tests/engine/benchmark_bicycle.hpp"
#include "tests/engine/named_problem.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

const Real tiny = Real("1e-24");

/// Distance of x + i y from the nearest of some eigenvalues of this multiplicity.
Real miss(const std::vector<Eigenvalue>& found, const Real& x, const Real& y, int multiplicity = 1) {
    Real nearest = 1000;
    for (const Eigenvalue& one : found)
        if (one.multiplicity == multiplicity)
            nearest = min(nearest, Real(abs(from_number(one.real) - x) + abs(from_number(one.imaginary) - y)));
    return nearest;
}

int count(const std::vector<Eigenvalue>& found) {
    int sum = 0;
    for (const Eigenvalue& one : found) sum += one.multiplicity;
    return sum;
}

Linearisation good(const Model& model, const std::string& formulation) {
    const Linearisation result = linearised(model, formulation);
    INFO(formulation << ": " << result.refusal);
    REQUIRE(result.refusal.empty());
    CHECK(result.uncertainty < 1e-22 * result.rate.value);
    CHECK(count(result.eigenvalues) + count(result.of_symmetries) == result.dimension);
    return result;
}

/// Lagrange's top of the registered problem with its axis upright, or hanging, that spins about it.
Model vertical_top(int up, const Real& spin) {
    Model model = standard_model("lagrange_top");
    Body& body = model.bodies[0];
    body.start.R = up > 0 ? Mat3(Mat3::Identity()) : Mat3(Vec3(1, -1, -1).asDiagonal());
    body.start.x = body.start.R * Vec3(0, 0, Real(1) / 2);
    body.start.v.setZero();
    body.start.omega = Vec3(0, 0, spin);
    return model;
}
const Real transverse_moment = Real(9) / 20, axial_moment = Real(3) / 10, mgl = Real("4.905");  // about its fixed point

Model rolling_upright(const Real& spin) {
    Model model = standard_model("rolling_disk");
    Body& body = model.bodies[0];
    body.start.R.col(2) = Vec3::UnitY(), body.start.R.col(0) = Vec3::UnitX(), body.start.R.col(1) = -Vec3::UnitZ();
    body.start.x = Vec3(0, 0, Real(1) / 2);
    body.start.omega = Vec3(0, 0, spin);
    body.start.v = Vec3(spin / 2, 0, 0);
    return model;
}

}  // namespace

TEST_CASE("the benchmark bicycle, linearised, has the published eigenvalues", "[published]") {
    for (const char* formulation : {"SO3xR3", "SE3"}) {
        const Linearisation result = good(bicycle(5), formulation);
        CHECK(result.dimension == 10);
        REQUIRE(result.motion.size() == 3);
        CHECK(result.motion[0].name == "translation along (1, 0, 0)");
        CHECK(result.motion[0].rate.value == 5);
        CHECK(result.motion[1].name == "spin of rear_wheel about (0, 1, 0)");
        const Real close = Real("1e-13");
        CHECK(miss(result.eigenvalues, at("-14.07838969279822"), 0) <= close);
        CHECK(miss(result.eigenvalues, at("-0.32286642900409"), 0) <= close);
        CHECK(miss(result.eigenvalues, at("-0.77534188219585"), at("4.46486771378823")) <= close);
        CHECK(miss(result.eigenvalues, at("-0.77534188219585"), -at("4.46486771378823")) <= close);
        CHECK(miss(result.eigenvalues, 0, 0) <= tiny);       // of the speed
        CHECK(miss(result.of_symmetries, 0, 0, 5) <= tiny);  // place, heading, angles of the wheels
    }
    Model heavier = bicycle(5);
    heavier.bodies[rear_body].mass *= 1 + at("1e-6");
    CHECK(miss(linearised(heavier, "SE3").eigenvalues, at("-14.07838969279822"), 0) > at("1e-9"));
}

TEST_CASE("a sleeping top is stable where C^2 n^2 > 4 A m g l") {
    for (const char* formulation : {"SO3xR3", "SE3", "S3xR3", "SO3", "S3"})
        for (const int spin : {5, 15}) {
            const Linearisation result = good(vertical_top(1, spin), formulation);
            const Real A = transverse_moment, C = axial_moment, square = C * C * spin * spin - 4 * A * mgl;
            REQUIRE((square > 0) == (spin == 15));
            const Real split = sqrt(abs(square)) / (2 * A), mean = C * spin / (2 * A);
            for (const int sign : {-1, 1})
                for (const int side : {-1, 1}) {
                    const Real growth = square < 0 ? Real(sign * split) : Real(0);
                    const Real frequency = square < 0 ? mean : Real(mean + sign * split);
                    CHECK(miss(result.eigenvalues, growth, side * frequency) <= tiny);
                }
            CHECK(miss(result.eigenvalues, 0, 0) <= tiny);
            CHECK(count(result.of_symmetries) == 1);
            REQUIRE(result.motion.size() == 1);
            CHECK(result.motion[0].name == "spin of top about (0, 0, 1)");
        }
}

TEST_CASE("a top in steady precession nutates with the frequency of the closed form") {
    // nu^2 = W^2 - 2 (m g l/A) cos theta + (m g l/(A W))^2 at the precession W.
    Model model = standard_model("lagrange_top");
    Body& body = model.bodies[0];
    const Vec3 lever(0, 0, Real(1) / 2);
    const LagrangeTop top = lagrange_top(body, lever, model.gravity.g);
    const SteadyPrecession steady = slow_precession(top, body.start.R, Real(15));
    const TopState start = steady_motion(top, steady, body.start.R, Real(0));
    body.start = {start.R * lever, start.R, start.R * start.omega.cross(lever), start.omega};
    const Real W = steady.precession, cosine = start.R(2, 2), A = transverse_moment;
    const Real nutation = sqrt(W * W - 2 * mgl / A * cosine + mgl / (A * W) * (mgl / (A * W)));
    for (const char* formulation : {"SE3", "SO3"}) {
        const Linearisation result = good(model, formulation);
        CHECK(miss(result.eigenvalues, 0, nutation) <= tiny);
        CHECK(miss(result.eigenvalues, 0, 0, 2) <= tiny);
        CHECK(miss(result.of_symmetries, 0, 0, 2) <= tiny);
        REQUIRE(result.motion.size() == 2);
        CHECK(abs(from_number(result.motion[0].rate) - abs(W)) <= tiny);
    }
}

TEST_CASE("small oscillations about equilibria have the frequencies of the closed form, with multiplicities") {
    const Linearisation hanging = good(vertical_top(-1, 0), "SO3xR3");
    CHECK(hanging.motion.empty());
    CHECK(miss(hanging.eigenvalues, 0, sqrt(mgl / transverse_moment), 2) <= tiny);
    CHECK(miss(hanging.eigenvalues, 0, -sqrt(mgl / transverse_moment), 2) <= tiny);
    // Two equal masses on a thread: w^2 = (2 -+ sqrt 2) g/L; rotations of point masses have no meaning.
    Model thread;
    thread.bodies = {{.name = "upper", .mass = 3, .start = {.x = Vec3(0, 0, -2)}, .point = true},
                     {.name = "lower", .mass = 3, .start = {.x = Vec3(0, 0, -4)}, .point = true}};
    thread.joints = {{.first = ground, .second = 0, .type = "distance", .length = 2},
                     {.first = 0, .second = 1, .type = "distance", .length = 2}};
    thread.gravity.g = Vec3(0, 0, -10);
    const Linearisation result = good(thread, "SE3");
    CHECK(result.dimension == 8);
    for (const int sign : {-1, 1})
        for (const int side : {-1, 1}) {
            const Real square = (2 + sign * sqrt(Real(2))) * 5;
            CHECK(miss(result.eigenvalues, 0, side * sqrt(square), 2) <= tiny);
        }
}

TEST_CASE("a disk that rolls upright falls below the critical speed only") {
    // lambda^2 = 4/5 (g/r - 3 W^2) of a thin disk.
    for (const int spin : {2, 3}) {
        const Linearisation result = good(rolling_upright(spin), "SO3xR3");
        const Real square = Real(4) / 5 * (2 * Real("9.81") - 3 * spin * spin), root = sqrt(abs(square));
        CHECK(miss(result.eigenvalues, square > 0 ? root : Real(0), square > 0 ? Real(0) : root) <= tiny);
        CHECK(miss(result.eigenvalues, 0, 0, 2) <= tiny);
        CHECK(miss(result.of_symmetries, 0, 0, 4) <= tiny);
    }
}

TEST_CASE("what moves unsteadily, or depends on time, is refused") {
    CHECK_THAT(linearised(standard_model("lagrange_top"), "SO3").refusal,
               Catch::StartsWith("it is neither an equilibrium nor a steady motion"));
    CHECK(linearised(standard_model("forced_heavy_top"), "SO3").refusal == "gravity is modulated");
    Model tilted = vertical_top(-1, 0);
    tilted.gravity.g += Vec3(Real("1e-6"), 0, 0);
    CHECK_THAT(linearised(tilted, "SO3").refusal,
               Catch::StartsWith("it is neither") && Catch::Matches(".* by [0-9.]+e-0[67] of the rate of the motion"));
}

namespace {

/// A block on a joint at a point where its weight has a moment, and that of a spring too; the axis is across gravity.
Model held_block(JointType type) {
    Model model;
    model.bodies = {{.name = "block", .mass = 3, .start = {.x = Vec3(1, Real(1) / 3, 2)}}};
    model.bodies[0].J = Vec3(3, 4, 5).asDiagonal();
    model.gravity.g = Vec3(0, 0, Real("-9.81"));
    model.join(ground, 0, Vec3(0, Real(1) / 7, 0), type, Vec3(3, 4, 0));
    return model;
}

}  // namespace

TEST_CASE("what joints hold at rest against its weight, or against springs, is an equilibrium") {
    for (const char* formulation : {"SO3xR3", "SE3", "S3xR3"}) {
        const Linearisation locked = good(held_block("fixed"), formulation);
        CHECK(locked.dimension == 0);
        CHECK(locked.motion.empty());
        Model sprung = held_block("fixed");
        sprung.gravity.g.setZero();
        for (const Real& sign : {Real(1), Real(-1)})
            sprung.springs.push_back({.r_first = Vec3(1 + 3 * sign, Real(1) / 3, 2), .stiffness = 100, .length = 1});
        CHECK(good(sprung, formulation).motion.empty());
        const Linearisation slide = good(held_block("prismatic"), formulation);
        CHECK(slide.dimension == 2);
        CHECK(miss(slide.of_symmetries, 0, 0) + miss(slide.eigenvalues, 0, 0) <= tiny);
    }
}

TEST_CASE("a slide that is not level is no equilibrium, however little it is off") {
    Model model = held_block("prismatic");
    model.gravity.g += Vec3(Real("1e-6"), 0, 0);
    CHECK_THAT(linearised(model, "SE3").refusal, Catch::StartsWith("it is neither"));
    CHECK_THAT(linearised(held_block("revolute"), "SE3").refusal, Catch::StartsWith("it is neither"));
}

TEST_CASE("a motion is linearised where it has got to, in place of the start") {
    Model model = vertical_top(-1, 0);
    Model turned = model;
    turned.bodies[0].start = vertical_top(1, 0).bodies[0].start;
    const Linearisation result = linearised(model, "SO3xR3", turned);
    CHECK(result.refusal == "");
    CHECK(miss(result.eigenvalues, sqrt(mgl / transverse_moment), 0, 2) <= tiny);  // upright it falls
    CHECK(miss(linearised(model, "SO3xR3").eigenvalues, 0, sqrt(mgl / transverse_moment), 2) <= tiny);
}

TEST_CASE("eigenvalues are counted with their multiplicities, split ones too") {
    MatX A = MatX::Zero(5, 5), S = MatX::Random(5, 5);
    A.diagonal() << 2, 2, 2, 1, -1;
    A(0, 1) = A(1, 2) = 1;
    A(3, 4) = -4, A(4, 3) = 3;
    const MatX B = S * A * S.inverse();
    const auto found = spectrum(B, 4);
    REQUIRE(found.size() == 3);
    CHECK(found[0].multiplicity == 3);
    CHECK(abs(found[0].real - 2) < Real("1e-28"));
    CHECK(abs(found[1].imaginary - sqrt(Real(11))) < Real("1e-28"));
    CHECK(abs(found[2].imaginary + sqrt(Real(11))) < Real("1e-28"));
}
