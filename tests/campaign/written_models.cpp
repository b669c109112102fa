// SPDX-License-Identifier: BSD-3-Clause
//
// A model contains what its config gives and nothing else.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "driver/plan/plan.hpp"
#include "kreisel_build.hpp"
#include "records/json/strict.hpp"

using namespace kreisel;
using nlohmann::ordered_json;

namespace {

const Engines written_engines{engine_binary64(), engine_binary64()};

Plan plan_of_written(const std::string& parameters, double end, long steps) {
    ordered_json config = {
        {"name", "written"}, {"kind", "trajectory"}, {"methods", {"rkmk/rk4"}}, {"metrics", ordered_json::array()}};
    config["problems"] = {{{"name", "multibody"}, {"parameters", ordered_json::parse(parameters)}}};
    config["formulations"] = {"SO3xR3", "SE3", "S3xR3"};
    config["time"] = {{"end", end}, {"steps", steps}};
    return plan_of(parse_document("written.json", config.dump(1)), written_engines);
}

/// The final states of all cells.
std::vector<ReportedState> final_states(const Plan& plan) {
    std::vector<ReportedState> states;
    for (const PlannedCell& planned : plan.cells) {
        const Outcome outcome = engine_binary64().run(planned.cell(), nullptr, {});
        REQUIRE(outcome.status == "ok");
        states.push_back(*outcome.final);
    }
    return states;
}

}  // namespace

TEST_CASE("a body without forces stays where it is, whatever its name", "[campaign]") {
    // The demonstration has a spring on a body of this name.
    const Plan plan = plan_of_written(R"({"gravity": [0, 0, 0], "joints": [],
        "bodies": [{"name": "rod", "mass": 1, "inertia": [1, 1, 1], "x": [0, 0, 0]}]})",
                                      0.5, 500);
    for (const ReportedState& state : final_states(plan))
        for (const Number& x : state.bodies.at(0).x) CHECK(x.value == 0);
}

TEST_CASE("bodies without joints fall freely, whatever their names", "[campaign]") {
    const Plan plan = plan_of_written(R"({"gravity": [0, 0, -9.81], "forces": [], "bodies": [
        {"name": "rod", "mass": 1, "inertia": [1, 1, 1], "x": [0.6, 0.4, 0]},
        {"name": "crank", "mass": 1, "inertia": [1, 1, 1], "x": [0.3, 0, 0]}]})",
                                      1, 1000);
    for (const ReportedState& state : final_states(plan)) {
        CHECK(state.multipliers.empty());
        for (const ReportedBody& body : state.bodies) CHECK(body.x[2].value == Approx(-4.905).epsilon(1e-13));
    }
}

TEST_CASE("the shipped config of a demonstration says what info shows", "[campaign]") {
    int shown = 0;
    for (const ProblemDescription& problem : engine_binary64().problems()) {
        CHECK(problem.demonstration.empty() == required_parameters(problem).empty());
        if (problem.demonstration.empty()) continue;
        INFO(problem.name);
        std::ifstream in(std::string(build::source_dir) + "/" + problem.demonstration_config);
        const std::string text(std::istreambuf_iterator<char>(in), {});
        const Plan plan = plan_of(parse_document(problem.demonstration_config, text), written_engines);
        CHECK(plan.cells.at(0).cell().problem == problem.name);
        CHECK(plan.cells.at(0).cell().parameters == demonstration_parameters(problem));
        ++shown;
    }
    CHECK(shown > 0);
}
