// SPDX-License-Identifier: BSD-3-Clause
//
// No bodies: an empty state passes through every method and projection. Problems refuse such parameters.
#include "engine/run.hpp"
#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

TEST_CASE("a model without bodies runs with every method and projection, in every formulation", "[methods]") {
    const Model nothing;
    const auto names = applicable(nothing);
    REQUIRE(names.size() == formulations().size() - 1);  // one takes one body
    for (const Method& entry : methods())
        for (const ProjectionMethod& projector : projections())
            for (const std::string& formulation : names) {
                const auto& only = projector.description.formulations;
                if (!only.empty() && std::find(only.begin(), only.end(), formulation) == only.end()) continue;
                if (!runs_on(entry, nothing, formulation)) continue;
                INFO(entry.description.name << ", " << projector.description.name << ", " << formulation);
                Trip trip(nothing, formulation, entry, projector.description.name);
                CHECK(trip.y.empty());
                CHECK(trip.run(1, 10) == Status::ok);
                CHECK(trip.run(-1, 3) == Status::ok);
                CHECK(trip.bodies().empty());
            }
}

TEST_CASE("a problem without bodies says so", "[methods]") {
    ParameterValues values = defaults(problem("double_pendulum"));
    values["bodies"] = std::vector<BodyData>();
    CHECK_THROWS_AS(problem("double_pendulum").build(Parameters(values)), ParameterError);
}
