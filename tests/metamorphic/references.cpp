// SPDX-License-Identifier: BSD-3-Clause
//
// References do not depend on the description of a motion, to 25 digits by series, and by extrapolation to its
// tolerance, in any place and units.
#include <catch2/catch.hpp>
#include <iostream>

#include "engine/reference/taylor/taylor_route.hpp"
#include "mechanics/model/scales.hpp"
#include "tests/metamorphic/judge.hpp"

using namespace kreisel;
using namespace kreisel::metamorphic;

#if KREISEL_QUAD

namespace {

metamorphic::Outcome by_extrapolation(const Model& model, const Real& t) {
    const ReferenceSolution solution = reference_solution(model, t);
    REQUIRE(solution.stopped.empty());
    metamorphic::Outcome outcome;
    outcome.bodies = solution.states;
    return outcome;
}

metamorphic::Outcome by_series(const Model& model, const Real& t) {
    TaylorRoute route(model);
    REQUIRE(route.advance(t, {}) == Status::ok);
    metamorphic::Outcome outcome;
    outcome.bodies = route.states();
    return outcome;
}

}  // namespace

TEST_CASE("references of all descriptions agree to 25 digits", "[metamorphic]") {
    int compared = 0;
    for (const char* name :
         {"heavy_top", "rolling", "winding", "driven", "closed loop", "prismatic joints and springs"}) {
        const NamedModel& named = named_model(name);
        const Real t = 4 * named.h;
        const metamorphic::Outcome exact = by_series(named.model, t);
        for (const Transformation& entry : transformations()) {
            const auto changed = entry.apply(named.model);
            if (!changed) continue;
            INFO(name << ", " << entry.name);
            const metamorphic::Outcome other = changed->back(by_series(changed->model, changed->time * t));
            CHECK(distance(exact, other, named.model) <= Real("1e-25"));
            ++compared;
        }
        for (const char* change : {"moved by 1000 km", "lengths times 2^-20", "time times 2^20", "a body split"}) {
            const auto changed = transformation(change).apply(named.model);
            INFO(name << ", " << change << ", by extrapolation");
            const metamorphic::Outcome other = changed->back(by_extrapolation(changed->model, changed->time * t));
            // Its own tolerance of 65536 eps, of the largest |x|.
            const Real far = changed->model.bodies[0].start.x.norm() / changed->length / extent(named.model);
            CHECK(distance(exact, other, named.model) <= max(Real("1e-25"), Real(65536 * epsilon * far)));
            ++compared;
        }
    }
    std::cout << compared << " references of other descriptions\n";
    CHECK(compared >= 120);
}

#endif
