// SPDX-License-Identifier: BSD-3-Clause
//
// Motions over a second as integrated by Simbody in joint coordinates.
#include <catch2/catch.hpp>

#include "mechanics/parts/driven_joints.hpp"
#include "tests/methods/stepping.hpp"
#include "tests/peers/simbody/compare.hpp"
#include "tests/peers/simbody/models.hpp"
#include "tests/peers/simbody/translate.hpp"

using namespace outside;

namespace {

std::vector<BodyState> by_simbody(const Model& model, double t_end, double accuracy) {
    Simbody simbody(translate(model));
    simbody.set(translate(starts(model)));
    simbody.run(t_end, accuracy);
    return translate(simbody.poses());
}

std::vector<BodyState> by_kreisel(const Model& model, const std::string& formulation, const Real& t_end, long steps) {
    stepping::Trip trip(model, formulation, method("rkmk/rk4"), "position_velocity");
    REQUIRE(trip.run(t_end, steps) == Status::ok);
    return trip.bodies();
}

void moves_alike(const Model& model, const Real& t_end) {
    const auto theirs = by_simbody(model, t_end, 1e-11), rough = by_simbody(model, t_end, 1e-6);
    for (const char* formulation : {"SO3xR3", "SE3"}) {
        const auto ours = by_kreisel(model, formulation, t_end, 2000);
        const Real fine = stepping::worst(distance(theirs, ours)), coarse = stepping::worst(distance(rough, ours));
        CAPTURE(formulation, fine, coarse);
        CHECK(fine < 1e-9);
        if (coarse > 1e-11) CHECK(fine < coarse / 20);  // fixed to the ground, nothing moves
    }
}

}  // namespace

TEST_CASE("three different bodies move as in Simbody") { moves_alike(three_bodies(), 1); }

TEST_CASE("closed loops move as in Simbody, which closes them by constraints") {
    moves_alike(models::closed_loop(), 1);
    moves_alike(models::standard("four_bar"), Real(1) / 2);
    moves_alike(models::standard("slider_crank"), Real(1) / 4);
}

TEST_CASE("joints of every kind but rolling move as in Simbody") {
    for (const JointType type : models::joint_types()) {
        CAPTURE(type.name());
        Model model = models::sprung(type);
        model.torsion_springs.clear();
        if (type == "gear" || type == "rack") continue;  // of bodies on the ground, below
        moves_alike(model, Real(1) / 2);
    }
}

TEST_CASE("bodies with prescribed coordinates move as in Simbody") {
    for (const JointType type : models::driven_types()) {
        CAPTURE(type.name());
        Model model = models::jointed(type);
        model.gravity.amplitude = 0;
        moves_alike(model, Real(1) / 2);
    }
}

namespace {

/// A closed loop whose first joint, that of a crank on the ground, turns by (rate) t + t^2/2 + A sin 3t.
Model with_driven_crank(const char* problem, const Real& rate, const Real& amplitude) {
    Model model = models::standard(problem);
    model.joints[0].type = driven("revolute", {.turn = true});
    model.joints[0].turn = {{0, rate, Real(1) / 2}, {{amplitude, 3, 0}}};
    project_start(model);
    return model;
}

}  // namespace

TEST_CASE("closed loops whose crank is driven move as in Simbody, and their joints pull as hard") {
    const struct {
        const char* problem;
        Real rate, t_end;
    } cranks[] = {{"slider_crank", 5, Real(1) / 2}, {"four_bar", -1, Real(1) / 2}, {"four_bar", 1, Real(1) / 4}};
    for (const auto& [problem, rate, t_end] : cranks) {
        CAPTURE(problem, rate);
        const Model model = with_driven_crank(problem, rate, Real(1) / 4);
        moves_alike(model, t_end);
        const Model start = frozen(model, 0, starts(model));
        const Difference d = difference(start, "SO3xR3", start, starts(model));
        CAPTURE(d.state, d.acceleration, d.reaction);
        CHECK(d.state < 1e-12);
        CHECK(d.acceleration < 1e-10);
        CHECK(d.reaction < 1e-10);
    }
}

TEST_CASE("control: Simbody shows a drive of a crank off by a millionth") {
    const auto ours = by_kreisel(with_driven_crank("slider_crank", 5, Real(1) / 4), "SO3xR3", Real(1) / 4, 1000);
    const Model other = with_driven_crank("slider_crank", 5, Real(1) / 4 + Real(1) / 1000000);
    CHECK(stepping::worst(distance(by_simbody(other, 0.25, 1e-11), ours)) > 1e-8);
}

namespace {

/// Two wheels on hinges and a slide on the ground, out of balance; the wheels mesh, the second one with a rack on the
/// slide.
Model geared_slide() {
    Model model = models::bodies_in_a_row(3);
    const Vec3 n(0, 0, 1), e(0, 1, 0), one(0, 0, 0), two(2, 0, 0), line(Real(5) / 2, -1, 0);
    model.join(ground, 0, one, "revolute", n);
    model.join(ground, 1, two, "revolute", n);
    model.join(ground, 2, line, "prismatic", e);
    Mat3 along, rack, pinion;
    along << -Vec3::UnitX(), n.cross(-Vec3::UnitX()), n;
    Joint gear{.first = 0, .second = 1, .type = "gear", .teeth = {30, 20}};
    gear.r_first = model.point_of(0, one), gear.r_second = model.point_of(1, two);
    gear.axes_first = model.axes_of(0, along), gear.axes_second = model.axes_of(1, along);
    Joint meshed{.first = 2, .second = 1, .type = "rack"};
    meshed.r_first = model.point_of(2, line), meshed.r_second = model.point_of(1, two);
    meshed.lead = -2 * pi() * n.cross(e).dot(line - two);
    const Real f = 2 * pi() * e.dot(line - two) / meshed.lead;
    rack << n, e.cross(n), e;
    pinion << e, n.cross(e), n;
    meshed.axes_first = model.axes_of(2, rack);
    meshed.axes_second = model.axes_of(1, SO3::exp(f * n) * pinion);
    model.joints.push_back(gear), model.joints.push_back(meshed);
    model.gravity.g = Vec3(1, -9, 2);
    project_start(model);
    return model;
}

}  // namespace

TEST_CASE("wheels and a rack move as in Simbody, which couples coordinates") {
    const Model model = geared_slide();
    moves_alike(model, 1);
    Model other = model;
    other.joints[3].teeth = {30, 21};
    const auto ours = by_kreisel(model, "SO3xR3", Real(1) / 2, 1000);
    CHECK(stepping::worst(distance(by_simbody(other, Real(1) / 2, 1e-9), ours)) > 1e-4);
}

TEST_CASE("bodies on bushings move as in Simbody") {
    for (const Model& built : {models::bent("universal"), models::softened("spherical")}) {
        Model model = built;
        model.polynomial_springs.clear(), model.attractions.clear();
        model.dampers.clear(), model.rotational_dampers.clear();
        moves_alike(model, Real(1) / 2);
    }
}

TEST_CASE("control: after a second Simbody shows an inertia off by a millionth") {
    Model other = three_bodies();
    other.bodies[2].J *= 1 + Real(1) / 1000000;
    const auto ours = by_kreisel(three_bodies(), "SO3xR3", 1, 2000);
    CHECK(stepping::worst(distance(by_simbody(other, 1, 1e-11), ours)) > 1e-8);
}
