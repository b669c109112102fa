// SPDX-License-Identifier: BSD-3-Clause
//
// NaN and infinity, in what a system says and in the state, end an implicit step as a status.
#include "tests/methods/implicit/for_each.hpp"
#include "tests/methods/poisoned.hpp"

namespace implicit_not_a_number {

using namespace kreisel;
using namespace models;
using namespace stepping;

TEST_CASE("NaN never ends as ok in an implicit step", "[methods]") {
    using enum PoisonedSystem::What;
    for (const Method& entry : methods()) {
        if (!entry.description.is_implicit() || !runs_on(entry, standard("double_pendulum"), "SO3xR3")) continue;
        for (const auto what : {acceleration, mass, applied, gyroscopic, position, velocity, jacobian})
            for (const Real& poison : {not_a_number, infinite})
                for (const int healthy_steps : {0, 3, 9}) {
                    // A method without multipliers uses only the index-1 form.
                    const bool multipliers = entry.description.reports_multipliers;
                    if (!multipliers && what != acceleration) continue;
                    if (multipliers && what == acceleration && healthy_steps > 0) continue;
                    // Rows on velocities alone do not enter, nor do their own.
                    if (multipliers && !entry.description.meets_velocities && what == velocity) continue;
                    // Variational methods take the gyroscopic force from the transport of momenta, and solve for none
                    // of the accelerations.
                    const bool variational = entry.description.claims(Property::symplectic);
                    if (variational && (what == gyroscopic || what == acceleration)) continue;
                    INFO(entry.description.name << ", quantity " << static_cast<int>(what) << ", step "
                                                << healthy_steps);
                    Trip trip(standard("double_pendulum"), "SO3xR3", entry);
                    PoisonedSystem system(*trip.system);
                    const auto integrator = entry.bind(system, default_options(entry.description.options));
                    const Real h = Real(1) / 100;
                    for (int i = 0; i < healthy_steps; ++i)
                        REQUIRE(integrator->step(h * i, h, trip.y.data()) == Status::ok);
                    const auto before = trip.y;
                    system.what = what, system.poison = poison;
                    CHECK(integrator->step(h * healthy_steps, h, trip.y.data()) == Status::non_finite);
                    CHECK(trip.y == before);
                    system.what = nothing;
                    CHECK(integrator->step(h * healthy_steps, h, trip.y.data()) == Status::ok);
                }
    }
}

TEST_CASE("NaN in the state never ends as ok in a step that meets constraints", "[methods]") {
    for_each_on_constraints([](const Method& entry) {
        const Real h = Real(1) / 100;
        for (const int healthy_steps : {0, 3}) {
            Trip start(standard("double_pendulum"), "SO3xR3", entry);
            for (std::size_t i = 0; i < start.y.size(); ++i) {
                Trip trip(standard("double_pendulum"), "SO3xR3", entry);
                for (int k = 0; k < healthy_steps; ++k)
                    REQUIRE(trip.integrator->step(h * k, h, trip.y.data()) == Status::ok);
                trip.y[i] = not_a_number;
                INFO("entry " << i << ", step " << healthy_steps);
                CHECK(trip.integrator->step(h * healthy_steps, h, trip.y.data()) != Status::ok);
            }
        }
    });
}

}  // namespace implicit_not_a_number
