// SPDX-License-Identifier: BSD-3-Clause
//
// What splitting methods preserve, and what they decline.
#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

std::vector<const Method*> splitting_methods() {
    std::vector<const Method*> found;
    for (const Method& entry : methods())
        if (entry.description.name.starts_with("splitting/")) found.push_back(&entry);
    return found;
}

/// Largest change of a first integral over a run, relative to its size.
Real change_of(const std::string& integral, Trip& trip, const Real& t_end, long steps) {
    const auto value = [&] {
        const std::vector<BodyState> bodies = trip.bodies();
        for (const FirstIntegral& one : trip.system->integrals())
            if (one.name == integral) return std::pair(one.value({bodies}), one.size({bodies}));
        throw std::out_of_range("no integral " + integral);
    };
    const Real before = value().first, h = t_end / Real(steps);
    Real most = 0;
    for (long i = 0; i < steps; ++i) {
        REQUIRE(trip.integrator->step(h * Real(i), h, trip.y.data()) == Status::ok);
        most = max(most, Real(abs(value().first - before) / value().second));
    }
    return most;
}

}  // namespace

TEST_CASE("splitting keeps the momenta of symmetries to round-off, and the energy in bounds", "[methods][splitting]") {
    for (const Method* entry : splitting_methods()) {
        if (KREISEL_QUAD && entry->description.name != "splitting/strang") continue;  // slow, and the same code
        INFO(entry->description.name);
        const auto change = [&](const std::string& integral, const Real& t_end) {
            Trip trip(standard("asymmetric_heavy_top"), "SO3", *entry);
            return change_of(integral, trip, t_end, 8 * static_cast<long>(to_double(t_end)));
        };
        CHECK(change("angular_momentum_vertical", 64) < 1024 * epsilon);
        const Real over_some_turns = change("energy", 16);
        CHECK(over_some_turns > 1000 * epsilon);
        CHECK(change("energy", 64) < 2 * over_some_turns);
    }
}

TEST_CASE("splitting is exact for a body on which nothing acts", "[methods][splitting]") {
    for (const Method* entry : splitting_methods()) {
        Trip one(standard("free_top"), "SO3xR3", *entry), many(standard("free_top"), "SO3xR3", *entry);
        REQUIRE(one.run(2, 1) == Status::ok);
        REQUIRE(many.run(2, 20) == Status::ok);
        for (std::size_t i = 0; i < one.y.size(); ++i) CHECK(abs(one.y[i] - many.y[i]) < 1000 * epsilon);
    }
}

TEST_CASE("splitting declines joints and dampers", "[methods][splitting]") {
    const Method& strang = method("splitting/strang");
    CHECK(strang.factory.declines(*make_system(standard("double_pendulum"), "SO3xR3")) != "");
    CHECK(strang.factory.declines(*make_system(damped("revolute"), "SO3xR3")) != "");
    CHECK(strang.factory.declines(*make_system(standard("heavy_top"), "SO3")) == "");
    Model model = standard("free_top");
    model.springs.push_back({.first = ground, .second = 0, .stiffness = 2, .damping = 1});
    CHECK(strang.factory.declines(*make_system(model, "SO3xR3")) != "");
}
