// SPDX-License-Identifier: BSD-3-Clause
//
// What plans estimate of the cost of cells, against counts of what they do.
#include <catch2/catch.hpp>
#include <string>

#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"
#include "tests/campaign/acceptance.hpp"

namespace estimated_costs {

using namespace kreisel;

/// A cell of 16 steps, planned in quad, where no cost is that of starting a cell.
PlannedCell planned(const std::string& problem, const std::string& metrics, const std::string& method = "rkmk/rk4") {
    const std::string config = R"({"name": "counted", "kind": "structure", "precision": "quad", "problems": [")" +
                               problem + R"("], "methods": [")" + method + R"("], "metrics": [)" + metrics +
                               R"(], "time": {"end": 0.25, "steps": 16}, "output": {"samples": 2}})";
    const Engines engines{engine_binary64(), engine_binary128()};
    return plan_of(parse_document("counted.json", config), engines).cells.at(0);
}

double solves(const PlannedCell& planned, const Engine& engine) {
    const Cost cost = engine.run(planned.cell(), nullptr, {}).cost;
    return static_cast<double>(cost.evaluations + cost.output_evaluations);
}

TEST_CASE("estimated costs know the steps that metrics of structure take", "[campaign]") {
    for (const std::string problem : {"free_top", "heavy_top", "double_pendulum"}) {
        const PlannedCell plain = planned(problem, R"("invariant.*")");
        for (const std::string metrics : {R"("structure.symplectic")", R"("structure.*")", R"("structure.reversal")"}) {
            const PlannedCell probed = planned(problem, metrics);
            const double counted = solves(probed, engine_binary64()) / solves(plain, engine_binary64());
            const double estimated = probed.weight / plain.weight;
            INFO(problem << " " << metrics << ": " << counted << " times as many solves, estimated " << estimated);
            CHECK(estimated / counted > 0.6);
            CHECK(estimated / counted < 1.6);
        }
    }
}

TEST_CASE("estimated costs know that implicit steps take more iterations in quad", "[campaign]") {
    const PlannedCell explicit_steps = planned("heavy_top", R"("invariant.*")");
    for (const std::string method : {"rkmk/implicit_midpoint", "rkmk/gauss2"}) {
        const PlannedCell steps = planned("heavy_top", R"("invariant.*")", method);
        const double counted = solves(steps, engine_binary128()) / solves(explicit_steps, engine_binary128());
        const double estimated = steps.weight / explicit_steps.weight;
        INFO(method << ": " << counted << " times as many solves, estimated " << estimated);
        CHECK(estimated / counted > 0.5);
        CHECK(estimated / counted < 2);
    }
}

}  // namespace estimated_costs
