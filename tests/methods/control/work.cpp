// SPDX-License-Identifier: BSD-3-Clause
//
// What a step costs beside its solves: exponentials and brackets, as the scheme has them.
#include <catch2/catch.hpp>

#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace stepping;

namespace {

struct Costs {
    const char* method;
    OptionValues options;
    long exponentials, brackets;
};

/// What has been counted, as "exponentials, brackets".
std::string text(const Work& work) { return std::to_string(work.exponentials) + ", " + std::to_string(work.brackets); }

}  // namespace

TEST_CASE("steps count their exponentials and brackets", "[methods]") {
    const std::vector<Costs> expected = {{"rkmk/rk4", {{"dexpinv", "exact"}}, 4, 0},
                                         {"rkmk/rk4", {{"dexpinv", 2L}}, 4, 6},
                                         {"rkmk/mk3", {}, 3, 1},
                                         {"rkmk/mk4", {}, 4, 2},
                                         {"crouch_grossman/cg3a", {}, 6, 0},
                                         {"commutator_free/cf3", {}, 3, 0},
                                         {"commutator_free/cf4", {}, 5, 0}};
    for (const Costs& costs : expected) {
        const Method& entry = method(costs.method);
        Trip trip(models::standard("forced_heavy_top"), "SE3", entry,
                  with_defaults(costs.options, entry.description.options));
        REQUIRE(trip.run(Real(1) / 100, 1) == Status::ok);
        INFO(costs.method);
        CHECK(text(trip.integrator->work()) == text({.exponentials = costs.exponentials, .brackets = costs.brackets}));
    }
}

TEST_CASE("an attempt takes the stages of the estimate on top, a rejected one keeps its first slope", "[methods]") {
    Trip trip(models::standard("forced_heavy_top"), "SE3", method("commutator_free/cf4"));
    std::vector<Real> y_new = trip.y, error(static_cast<std::size_t>(trip.system->state_group().dim()));
    const auto attempt = [&](const Real& h) {
        REQUIRE(trip.integrator->attempt(0, h, trip.y.data(), y_new.data(), error.data()) == Status::ok);
    };
    REQUIRE(trip.integrator->start(0, trip.y.data()) == Status::ok);
    const long before = trip.system->evaluations();
    attempt(Real(1) / 100);
    CHECK(text(trip.integrator->work()) == "8, 0");
    CHECK(trip.system->evaluations() - before == 5);
    attempt(Real(1) / 200);
    CHECK(trip.system->evaluations() - before == 9);
}
