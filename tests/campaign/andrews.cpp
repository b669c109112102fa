// SPDX-License-Identifier: BSD-3-Clause
//
// The shipped squeezing mechanism of Andrews against the angles and rates at 0.03 s that the test set for IVP solvers
// publishes (PSIDE, tolerance 1e-14; the data are those of Hairer and Wanner [hairer1996, Sec. VII.7]).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "driver/config/shipped.hpp"
#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"

using namespace kreisel;

namespace {

/// Of a body that turns about z: its angle now and at the start, where R is the identity, and its rate.
struct Turned {
    const char* body;
    double start, angle, rate;
};
constexpr Turned published[] = {{"K1", -0.0617138900142764496, 15.81077119629904, 1139.920302151208},
                                {"K3", 0.455279819163070380, 0.04082224013073101, 11.03291221937134},
                                {"K5", 0.487364979543842550, 0.5244099658805304, 0.5735699284790808},
                                {"K7", 1.23054744454982119, 1.048080741042263, 0.3231791658026955}};

Cell andrews_cell() {
    const Engines engines{engine_binary64(), engine_binary64()};
    const Plan plan = plan_of(read_document(config_file("work_precision_andrews")), engines);
    for (const PlannedCell& planned : plan.cells)
        if (planned.cell().method == "rkmk/verner8" && planned.cell().tolerance > 0) return planned.cell();
    return {};
}

}  // namespace

TEST_CASE("Andrews' squeezing mechanism ends where the test set says", "[campaign]") {
    Cell cell = andrews_cell();
    cell.t_end = 0.03, cell.tolerance = 1e-12;
    const Outcome outcome = engine_binary64().run(cell, nullptr, {});
    REQUIRE(outcome.status == "ok");
    CHECK_FALSE(outcome.constraints.has_redundant_rows());
    for (const Turned& turned : published) {
        const auto& bodies = outcome.final->bodies;
        const auto body =
            std::find_if(bodies.begin(), bodies.end(), [&](const auto& b) { return b.name == turned.body; });
        REQUIRE(body != bodies.end());
        const double angle = std::atan2(body->R[3].value, body->R[0].value);
        INFO(turned.body);
        CHECK(std::abs(std::remainder(angle + turned.start - turned.angle, 2 * std::acos(-1.0))) < 1e-8);
        CHECK(std::abs(body->omega[2].value - turned.rate) < 1e-6);
    }
}
