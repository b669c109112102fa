// SPDX-License-Identifier: BSD-3-Clause
//
// Motions over a second as integrated by Simbody in joint coordinates.
#include <catch2/catch.hpp>

#include "tests/methods/stepping.hpp"
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
