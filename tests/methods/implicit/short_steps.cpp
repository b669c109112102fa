// SPDX-License-Identifier: BSD-3-Clause
//
// Steps so short that places over h are far larger than the motion.
#include "tests/methods/stepping.hpp"

namespace implicit_short_steps {

using namespace kreisel;
using namespace models;
using namespace stepping;

TEST_CASE("short steps on positions alone add up no round-off of places over h", "[methods]") {
    if (KREISEL_QUAD) return;  // it shows where eps/h^2 is larger than h^2
    const Real t_end = Real(1) / 16;
    Trip exact(standard("forced_heavy_top"), "SO3xR3", method("rkmk/rk4"), "position_velocity");
    REQUIRE(exact.run(t_end, 512) == Status::ok);
    for (const Method& entry : methods()) {
        if (entry.description.order.configuration == 1) continue;  // its own error is larger
        if (!entry.description.reports_multipliers || entry.description.meets_velocities) continue;
        INFO(entry.description.name);
        Trip trip(standard("forced_heavy_top"), "SO3xR3", entry);
        REQUIRE(trip.run(t_end, 16384) == Status::ok);
        CHECK(worst(distance(trip.bodies(), exact.bodies())) < 1e-8);
    }
}

TEST_CASE("steps onto positions end however short they are", "[methods]") {
    // What changes velocities is known to the round-off of places over h, 8 million times that of the velocities.
    const Real h = Real(1) / 8388608;
    constexpr long steps = 256;
    for (const char* problem : {"double_pendulum", "forced_heavy_top"}) {
        Trip exact(standard(problem), "SO3xR3", method("rkmk/rk4"));
        REQUIRE(exact.run(h * Real(steps), 16) == Status::ok);
        for (const Method& entry : methods()) {
            if (!entry.description.meets_positions || !runs_on(entry, standard(problem), "SO3xR3")) continue;
            INFO(entry.description.name << " on " << problem);
            Trip trip(standard(problem), "SO3xR3", entry);
            REQUIRE(trip.run(h * Real(steps), steps) == Status::ok);
            // Velocities that follow from positions alone have the round-off of places over h themselves.
            const Real bound = Real(1) / (entry.description.meets_velocities ? 100000000 : 1000000);
            CHECK(worst(distance(trip.bodies(), exact.bodies())) < bound);
        }
    }
}

TEST_CASE("steps from rest that are too short for places to tell the motion take few iterations", "[methods]") {
    if (KREISEL_QUAD) return;  // there they are not too short
    Model model = standard("forced_heavy_top");
    model.bodies[0].start.v = model.bodies[0].start.omega = Vec3::Zero();
    const Real h = Real(1) / 8589934592;
    constexpr long steps = 64;
    Trip trip(model, "SO3xR3", method("symmetric_projection/gauss2"));
    REQUIRE(trip.run(h * Real(steps), steps) == Status::ok);
    CHECK(trip.integrator->work().newton_iterations <= 14);
}

}  // namespace implicit_short_steps
