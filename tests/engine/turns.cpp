// SPDX-License-Identifier: BSD-3-Clause
//
// The two routes, and closed forms, on torsion springs that make several turns.
#include "tests/engine/two_routes.hpp"
#include "tests/mechanics/models/turning.hpp"

using namespace kreisel;
using namespace reference_tests;
using namespace models;

namespace {

std::vector<Turner> turners() {
    return {wheel("revolute", 10),
            wheel("revolute", 0, 20),
            wheel("revolute", 0, 0, 3),
            crooked(30, 1),
            crooked(-25, pi() - Real(1) / 1000000),
            moving_pair(25)};
}

/// Of states from the closed form, in angles (rad) and rates (rad/s).
Real miss(const Turner& turner, const Real& t, const std::vector<BodyState>& states) {
    const auto [theta, rate] = turner.exact(t);
    return abs(turner.rate(states) - rate);
}

}  // namespace

TEST_CASE("two routes agree to 25 digits on springs through several turns, and with closed forms") {
    for (const Turner& turner : turners()) {
        const Real t = 2;
        const ReferenceSolution first = reference_solution(turner.model, t);
        REQUIRE(first.stopped.empty());
        const Real difference = relative_difference(first, taylor(turner.model, t));
        CAPTURE(turner.name, to_double(turner.exact.rate), to_double(difference));
        CHECK(difference < Real("1e-25"));
        CHECK(miss(turner, t, first.states) < Real("1e-23"));
        const Real theta = turner.exact(t).first;
        CHECK(abs(first.angles.at(0).theta - theta) < Real("1e-23"));
        CHECK(abs(theta - 2 * pi() * Real(first.angles.at(0).turns)) <= pi() + Real("1e-20"));
    }
}

TEST_CASE("the horizon of a spring is not where it has made half a turn") {
    const Turner turner = wheel("revolute", 10);
    const ReferenceSolution solution = confirmed_reference(turner.model, 8);
    CHECK(solution.horizon == 8);
    CHECK(solution.stopped.empty());
    CHECK(miss(turner, 8, solution.states) < Real("1e-22"));
    CHECK(solution.omega_error < Real("1e-22"));
}

TEST_CASE("a spring with another number of turns is another motion, by both routes") {
    Turner turner = wheel("revolute", 10);
    turner.model.torsion_springs[0].turns = 1;
    const ReferenceSolution first = reference_solution(turner.model, 1);
    CHECK(miss(turner, 1, first.states) > 1);
    CHECK(miss(turner, 1, taylor(turner.model, 1).states) > 1);
}

TEST_CASE("both routes say so where the axes of a spring part") {
    Turner turner = wheel("spherical", 0);
    turner.model.bodies[0].start.omega = Vec3(0, 2, 0);
    CHECK(reference_solution(turner.model, 1).stopped == "turn_lost");
    TaylorRoute route(turner.model);
    CHECK(route.advance(1, {}) == Status::turn_lost);
}
