// SPDX-License-Identifier: BSD-3-Clause
//
// Solvers with multipliers among their unknowns report them: they approach those of the index-1 form.
#include <catch2/catch.hpp>

#include "methods/simulation.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;

namespace {

/// |lambda - lambda(t, y)| over |lambda| at t = 1/2 of the top.
double distance_to_index_1(const std::string& method, const Real& tolerance) {
    Simulation top(models::standard("forced_heavy_top"), {.method = method, .tolerance = tolerance});
    REQUIRE(top.restart_to(Real(1) / 2) == Status::ok);
    CHECK(top.multipliers() == nullptr);
    REQUIRE(top.advance(Real(1) / 2) == Status::ok);
    REQUIRE(top.multipliers() != nullptr);
    System& system = top.system();
    const auto rows = static_cast<std::size_t>(system.constraints());
    std::vector<Real> dv(static_cast<std::size_t>(system.velocities())), lambda(rows);
    REQUIRE(system.accelerations(top.time(), top.q(), top.v(), dv.data(), lambda.data()) == Status::ok);
    Real apart = 0, size = 0;
    for (std::size_t i = 0; i < rows; ++i) {
        apart += abs(top.multipliers()[i] - lambda[i]);
        size += abs(lambda[i]);
    }
    return to_double(apart / size);
}

}  // namespace

TEST_CASE("multipliers of other libraries approach those of the index-1 form", "[peers]") {
    for (const Method& entry : methods()) {
        if (!entry.description.own_control || !entry.description.reports_multipliers) continue;
        INFO(entry.description.name);
        const double coarse = distance_to_index_1(entry.description.name, Real(1) / 10000);
        const double fine = distance_to_index_1(entry.description.name, Real(1) / 1000000000);
        CHECK(coarse < 0.1);
        CHECK(fine < coarse / 100);
        CHECK(fine > 0);
    }
}
