// SPDX-License-Identifier: BSD-3-Clause
//
// Multipliers that a method solves for: their order from the first steps on, what a run reports, and a
// step that fails.
#include <cmath>

#include "engine/run.hpp"
#include "engine/skip.hpp"
#include "tests/methods/implicit/for_each.hpp"
#include "tests/methods/poisoned.hpp"

namespace implicit_multipliers {

using namespace kreisel;
using namespace models;
using namespace stepping;

TEST_CASE("multipliers of implicit Euler steps on positions are of order 1 from the second step on", "[methods]") {
    // The first one goes from velocities on C v + b = 0 to chords, which are off it by h/2 xi: half of xi is missing in
    // C v', and lambda is wrong by S^{-1} xi/2.
    struct Errors {
        double plain, without_the_chord;
    };
    const auto errors_after = [](int steps, const Real& h) {
        Trip trip(standard("forced_heavy_top"), "SO3xR3", method("multistep/bliedf1_index3"));
        REQUIRE(trip.run(steps * h, steps) == Status::ok);
        System& s = *trip.system;
        const Real t = steps * h, *y = trip.y.data(), *v = s.v(y);
        VecX dv(6), exact(3), xi(3), of_chord(3);
        REQUIRE(s.accelerations(t, y, v, dv.data(), exact.data()) == Status::ok);
        s.acceleration_bias(t, y, v, xi.data());
        xi /= -2;
        const VecX zero = VecX::Zero(6);
        REQUIRE(s.solve_kkt(t, y, zero.data(), xi.data(), dv.data(), of_chord.data()) == Status::ok);
        const VecX error = Eigen::Map<const VecX>(trip.integrator->multipliers(), 3) - exact;
        return Errors{to_double(error.norm() / exact.norm()), to_double((error - of_chord).norm() / exact.norm())};
    };
    const Real h = Real(1) / 8192;
    const Errors first = errors_after(1, h), first_of_long = errors_after(1, 2 * h);
    CHECK(std::log2(first_of_long.plain / first.plain) == Approx(0).margin(0.1));
    CHECK(std::log2(first_of_long.without_the_chord / first.without_the_chord) == Approx(1).margin(0.1));
    CHECK(first.without_the_chord < first.plain / 10);
    for (const int steps : {2, 8})
        CHECK(std::log2(errors_after(steps, 2 * h).plain / errors_after(steps, h).plain) == Approx(1).margin(0.1));
}

TEST_CASE("a run reports the multipliers of the method, where it has any", "[methods]") {
    for_each_on_constraints([](const Method& entry) {
        Cell cell{.problem = "forced_heavy_top",
                  .parameters = defaults(problem("forced_heavy_top")),
                  .formulation = "SO3xR3",
                  .method = entry.description.name,
                  .options = default_options(entry.description.options),
                  .projection = "none",
                  .projection_options = {},
                  .t_end = 1,
                  .steps = 64,
                  .samples = 0,
                  .metrics = {}};
        CHECK(why_skipped(cell).empty());
        const Outcome outcome = run_cell(cell, nullptr, {});
        REQUIRE(outcome.status == "ok");
        Trip trip(standard("forced_heavy_top"), "SO3xR3", entry);
        REQUIRE(trip.run(1, 64) == Status::ok);
        VecX dv(6), from_state(3);
        const Real* v = trip.system->v(trip.y.data());
        REQUIRE(trip.system->accelerations(1, trip.y.data(), v, dv.data(), from_state.data()) == Status::ok);
        for (std::size_t i = 0; i < 3 && entry.description.reports_multipliers; ++i) {
            CHECK(from_number(outcome.final->multipliers.at(i)) == trip.integrator->multipliers()[i]);
            CHECK(from_number(outcome.final->multipliers.at(i)) != from_state[static_cast<Eigen::Index>(i)]);
        }
        cell.projection = "position";
        CHECK(why_skipped(cell).find("nothing is left to project") != std::string::npos);
    });
}

TEST_CASE("a step that fails leaves the multipliers of the last one", "[methods]") {
    // Rows are redundant, and those of least norm depend on the pose at which they act.
    const Model model = linkages::double_scott_russell();
    const Real h = Real(1) / 100;
    for (const Method& entry : methods()) {
        if (!entry.description.reports_multipliers || !runs_on(entry, model, "SO3xR3")) continue;
        INFO(entry.description.name);
        for (const int healthy_steps : {0, 3}) {
            Trip sound(model, "SO3xR3", entry), trip(model, "SO3xR3", entry);
            PoisonedSystem system(*trip.system);
            const auto integrator = entry.bind(system, default_options(entry.description.options));
            for (int i = 0; i < healthy_steps; ++i) {
                REQUIRE(sound.integrator->step(h * i, h, sound.y.data()) == Status::ok);
                REQUIRE(integrator->step(h * i, h, trip.y.data()) == Status::ok);
            }
            system.what = PoisonedSystem::What::applied, system.poison = not_a_number;
            REQUIRE(integrator->step(h * healthy_steps, h, trip.y.data()) != Status::ok);
            system.what = PoisonedSystem::What::nothing;
            REQUIRE((integrator->multipliers() != nullptr) == (healthy_steps > 0));
            if (healthy_steps == 0) continue;
            const Real *left = integrator->multipliers(), *expected = sound.integrator->multipliers();
            for (int i = 0; i < system.constraints(); ++i) CHECK(abs(left[i] - expected[i]) <= 1000000 * epsilon);
        }
    }
}

}  // namespace implicit_multipliers
