// SPDX-License-Identifier: BSD-3-Clause
//
// Mechanisms that are admissible: every type of joint and force, those that kreisel ships.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "kreisel_build.hpp"
#include "tests/campaign/mechanisms/chain.hpp"

namespace kreisel::mechanism_tests {

namespace {

std::string text_of(const std::string& file) {
    std::ifstream in(std::string(build::source_dir) + "/" + file);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("every type of joint and of force makes a mechanism", "[campaign]") {
    const std::vector<std::pair<std::string, std::string>> accepted = {
        {"/joints/1",
         R"({"type": "revolute", "between": ["crank", "rod"], "point": [1, 0, 0], "axes": [[0, 2, 0], [0, -1, 0]]})"},
        {"/joints/1",
         R"({"type": "universal", "between": ["crank", "rod"], "point": [1, 0, 0], "axes": [[0, 2, 0], [0, 0, 1]]})"},
        {"/joints/1",
         R"({"type": "prismatic", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], "axis": [1, 0, 0]})"},
        {"/joints/1", R"({"type": "cylindrical", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], )"
                      R"("axis": [1, 0, 0]})"},
        {"/joints/1",
         R"({"type": "planar", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 3, 2]], "axis": [1, 0, 0]})"},
        {"/joints/1", R"({"type": "fixed", "between": ["crank", "rod"], "point": [1, 0, 0]})"},
        {"/joints/1",
         R"({"type": "distance", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 0, 2]], "length": 2})"},
        {"/joints/2",
         R"({"type": "distance", "between": ["bob", "rod"], "points": [[2, 0, 0], [1, 0, 2]], "amplitude": -0.5})"},
        {"/joints/1", R"({"type": "rolling", "between": ["ground", "rod"], "points": [[5, 0, -1], [1.5, 0, 0]], )"
                      R"("axes": [[0, 0, 1], [0, 1, 0]], "radius": 1})"},
        {"/joints/1", R"({"type": "distance", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], )"
                      R"("amplitude": 0.5, "frequency": 2})"},
        {"/joints/0/turn", R"({"polynomial": [0, 2, 1], "sinusoids": [{"amplitude": 0.1, "frequency": 20}]})"},
        {"/joints/1", R"({"type": "prismatic", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], )"
                      R"("axis": [1, 0, 0], "shift": {"polynomial": [0, 0, 0.1]}})"},
        {"/joints/1", R"({"type": "cylindrical", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], )"
                      R"("axes": [[1, 0, 0], [2, 0, 0]], "turn": {"polynomial": [0, 2]}, "shift": {"sinusoids": )"
                      R"([{"amplitude": 0.2, "frequency": 1, "phase": 0.5}, )"
                      R"({"amplitude": -0.2, "frequency": 2, "phase": 0.5}]}})"},
        {"/joints/1", R"({"type": "screw", "between": ["crank", "rod"], "points": [[1, 0, 0], [1.5, 0, 0]], )"
                      R"("axis": [1, 0, 0], "lead": -0.3})"},
        {"/joints/1", R"({"type": "gear", "between": ["crank", "rod"], "points": [[0, 0, 0], [1.5, 0, 0]], )"
                      R"("axis": [0, 1, 0], "teeth": [20, -30]})"},
        {"/joints/1", R"({"type": "rack", "between": ["rod", "crank"], "points": [[1.5, 0, 0.2], [0, 0, 0]], )"
                      R"("axes": [[1, 0, 0], [0, 1, 0]]})"},
        {"/joints", "[]"},
        {"/bodies/0/quaternion", "[0.6, 0.8, 0, 0]"},
        {"/forces/0",
         R"({"type": "spring", "between": ["ground", "bob"], "points": [[0, 0, 3], [2, 0, 0]], "stiffness": 3, )"
         R"("damping": 1, "length": 2})"},
        {"/forces/0",
         R"({"type": "spring", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 0, 0]], "stiffness": 3})"},
        {"/forces/0",
         R"({"type": "torsion_spring", "between": ["ground", "crank"], "axis": [0, 1, 0], "stiffness": 3, )"
         R"("angle": 0.5})"},
        {"/forces/0", R"({"type": "torque", "body": "rod", "value": [0, 0, 1], "frame": "body"})"},
        {"/forces/0",
         R"({"type": "force", "body": "bob", "value": [0, 0, 1], "point": [2, 0, 0], "amplitude": 1, "frequency": 2})"},
    };
    for (const auto& change : accepted) {
        INFO(change.first << " = " << change.second);
        const ordered_json parameters = changed({change});
        CHECK(refusal(parameters) == "");
        for (const PlannedCell& planned : plan_with(parameters).cells) {
            INFO(planned.cell().formulation << planned.skip_reason());
            CHECK(engine_binary64().run(planned.cell(), nullptr, {}).status == "ok");
        }
    }
}

TEST_CASE("the mechanism of the README is admissible", "[campaign]") {
    const std::string readme = text_of("README.md");
    const auto begin = readme.find("{\"name\": \"multibody\"");
    REQUIRE(begin != std::string::npos);
    const auto entry = ordered_json::parse(readme.substr(begin, readme.find("```", begin) - begin));
    CHECK(refusal(entry.at("parameters")) == "");
}

TEST_CASE("the shipped mechanism has every formulation and keeps to its joints", "[campaign]") {
    const Plan plan =
        plan_of(parse_document("multibody.json", text_of("experiments/mechanisms/multibody.json")), engines);
    CHECK(plan.skipped() == 0);
    CHECK(plan.warnings.empty());
    for (const PlannedSystems::Shared& system : plan.systems.kinds()) {
        CHECK(system->bodies == 4);
        CHECK(system->constraints.rows == 18);
    }
}

TEST_CASE("redundant rows on a base that turns are chosen anew as it does", "[campaign]") {
    // A lead screw of 0.05 m in a turn moves a slide on a turntable, on which each has a joint of its own.
    const Plan plan = plan_with(ordered_json::parse(R"({
        "gravity": [0, 0, 0],
        "bodies": [{"name": "table", "mass": 5, "inertia": [0.5, 0.5, 1], "x": [0, 0, 0]},
                   {"name": "spindle", "mass": 1, "inertia": [0.002, 0.01, 0.01], "x": [0.5, 0, 0.1]},
                   {"name": "slide", "mass": 2, "inertia": [0.02, 0.02, 0.02], "x": [0.3, 0.1, 0.1]}],
        "joints": [{"type": "revolute", "between": ["ground", "table"], "point": [0, 0, 0], "axis": [0, 0, 1],
                    "turn": {"polynomial": [0, 3]}},
                   {"type": "revolute", "between": ["table", "spindle"], "point": [0.5, 0, 0.1], "axis": [1, 0, 0],
                    "turn": {"polynomial": [0, 20]}},
                   {"type": "prismatic", "between": ["table", "slide"], "point": [0.3, 0.1, 0.1], "axis": [1, 0, 0]},
                   {"type": "screw", "between": ["spindle", "slide"], "point": [0.3, 0, 0.1], "axis": [1, 0, 0],
                    "lead": 0.05}]})"));
    REQUIRE(plan.cells.size() == 3);
    const double place = 0.3 - 0.05 * 20 / 6.283185307179586;  // along the table after 1 s
    for (const PlannedCell& planned : plan.cells) {
        Cell cell = planned.cell();
        cell.steps = 1000;
        INFO(cell.formulation);
        const Outcome outcome = engine_binary64().run(cell, nullptr, {});
        REQUIRE(outcome.status == "ok");
        const ReportedBody& slide = outcome.final->bodies.at(2);
        CHECK(std::abs(slide.x[0].value - (std::cos(3.0) * place - std::sin(3.0) * 0.1)) < 1e-5);
        CHECK(std::abs(slide.x[1].value - (std::sin(3.0) * place + std::cos(3.0) * 0.1)) < 1e-5);
    }
}

}  // namespace kreisel::mechanism_tests
