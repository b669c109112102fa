// SPDX-License-Identifier: BSD-3-Clause
//
// What check, plan and run say of a run before it, and how planning grows.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "driver/plan/estimate/amounts.hpp"
#include "driver/plan/estimate/estimate.hpp"
#include "records/json/strict.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;
using Catch::Contains;

namespace {

std::string config(const nlohmann::json& more = nlohmann::json::object()) {
    nlohmann::json json = {{"name", "estimated"},
                           {"kind", "drift"},
                           {"problems", {"heavy_top"}},
                           {"methods", {"rkmk/rk4"}},
                           {"time", {{"end", 1}, {"steps", 1000}}}};
    json.merge_patch(more);
    return json.dump();
}

Estimate estimated(const nlohmann::json& more = nlohmann::json::object()) {
    return estimate_of(plan_of(parse_document("t", config(more)), one_engine));
}

nlohmann::json counts_to(long last) {
    nlohmann::json counts = nlohmann::json::array();
    for (long steps = 1; steps <= last; ++steps) { counts.push_back(steps); }
    return counts;
}

}  // namespace

TEST_CASE("sizes are told with two digits") {
    CHECK(size_text(0) == "0 B");
    CHECK(size_text(512) == "512 B");
    CHECK(size_text(2500) == "2.5 kB");
    CHECK(size_text(4e7) == "40 MB");
    CHECK(size_text(1.5e15) == "1.5 PB");
}

TEST_CASE("check and plan say what a run takes") {
    const ScratchFolder scratch;
    const std::string file = scratch.file("c.json", config());
    const std::string said = "; about 0.0 s of CPU time, 45 MB of memory, ";
    CHECK_THAT(run_program({"check", file}).out, Contains("good; 1 cell: 1 to run, 0 skipped" + said));
    CHECK_THAT(run_program({"plan", file}).out, Contains("1 cell: 1 to run, 0 skipped" + said));
    const auto json = nlohmann::json::parse(run_program({"plan", file, "--json"}).out);
    CHECK(json["estimate"]["memory"].get<double>() > 1e7);
    CHECK(json["estimate"]["disk"].get<double>() > 1000);
    CHECK(json["estimate"]["cpu_s"].get<double>() > 0);
}

TEST_CASE("estimates grow with cells, steps, samples and digits") {
    const Estimate one = estimated();
    CHECK(estimated({{"time", {{"steps", {1000, 1001}}}}}).disk == Approx(2 * one.disk));
    CHECK(estimated({{"time", {{"steps", 2000000}}}}).seconds > 500 * one.seconds);
    CHECK(estimated({{"output", {{"samples", 1000}}}}).disk > one.disk + 1000 * 19 * 19);
    CHECK(estimated({{"precision", "quad"}}).disk > 1.5 * one.disk);
    CHECK(estimated({{"metrics", nlohmann::json::array()}}).disk < one.disk);
}

TEST_CASE("a run says before what takes long, and is refused where there is surely no room") {
    const ScratchFolder scratch;
    const auto out = (scratch / "out").string();
    const auto huge = scratch.file(
        "huge.json", config({{"time", {{"steps", {1000000000, 500000000, 100000000}}}},
                             {"output", {{"samples", 10000000}}},
                             {"problems", {{{"name", "heavy_top"}, {"parameters", {{"mass", counts_to(4000)}}}}}},
                             {"precision", {"double", "quad"}}}));
    const auto refused = run_program({"run", huge, "-o", out});
    CHECK(refused.code == 3);
    CHECK_THAT(refused.messages, Contains(out + ": results take about ") && Contains(" are free"));
    CHECK_FALSE(std::filesystem::exists(out));
    const auto file = scratch.file("c.json", config({{"time", {{"steps", 2}}}}));
    CHECK_THAT(run_program({"run", file, "-o", out}).messages, !Contains("CPU time"));
    const auto tight = run_program({"run", file, "-o", out, "--overwrite", "--max-memory", "20MB"});
    CHECK(tight.code == 0);
    CHECK_THAT(tight.messages, Contains("warning: " + out + ": the run takes about 45 MB of memory"));
}

TEST_CASE("a plan of many cells keeps what they have in common once") {
    const Plan plan = plan_of(parse_document("t", config({{"time", {{"steps", counts_to(20000)}}}})), one_engine);
    REQUIRE(plan.cells.size() == 20000);
    CHECK(sizeof(PlannedCell) <= 64);
    for (const PlannedCell& planned : plan.cells) { REQUIRE(planned.run == plan.cells.front().run); }
    CHECK(plan.cells[41].cell().steps == 42);
    CHECK(plan.cells[41].identity().steps == 42);
    CHECK(plan.cells[41].identity().h == 1.0 / 42);
    CHECK(plan.cells[41].identity().cell == plan.cells[41].hash());
}

TEST_CASE("many values of a parameter are kept as numbers, and problems are made of them") {
    const auto masses = [](long last) {
        const nlohmann::json problem = {{"name", "heavy_top"}, {"parameters", {{"mass", counts_to(last)}}}};
        return plan_of(parse_document("t", config({{"problems", {problem}}, {"metrics", nlohmann::json::array()}})),
                       one_engine);
    };
    const Plan plan = masses(20000);
    REQUIRE(plan.cells.size() == 20000);
    for (const PlannedCell& planned : plan.cells) { REQUIRE(planned.run == plan.cells.front().run); }
    CHECK(plan.systems.kinds().size() == 1);
    CHECK(plan.cells[41].cell().parameters.at("mass") == ParameterValue(42.0));
    CHECK(plan.cells[41].label() == "heavy_top, mass = 42");
    CHECK(parse_exactly(plan.cells[41].identity().parameters).at("mass").text == "42");
    CHECK(plan.cells[41].hash() == masses(42).cells[41].hash());
    CHECK(plan.cells[41].hash() != plan.cells[40].hash());
}

TEST_CASE("values that are given twice are found among many") {
    const ScratchFolder scratch;
    nlohmann::json steps = counts_to(20000), masses = counts_to(20000);
    steps.push_back(7);
    masses.push_back(9);
    const auto of_steps = scratch.file("s.json", config({{"time", {{"steps", steps}}}}));
    CHECK_THAT(run_program({"check", of_steps}).messages, Contains("/time/steps/20000: expected each number of steps "
                                                                   "once, got 7 again"));
    const auto of_masses =
        scratch.file("m.json", config({{"problems", {{{"name", "heavy_top"}, {"parameters", {{"mass", masses}}}}}}}));
    CHECK_THAT(run_program({"check", of_masses}).messages, Contains("expected each value once, got 9 again"));
}

TEST_CASE("thousands of errors are counted, and the first twenty shown in their order") {
    const ScratchFolder scratch;
    nlohmann::json keys;
    for (int i = 0; i < 5000; ++i) { keys["key" + std::to_string(100000 + i)] = i; }
    const std::string said = run_program({"check", scratch.file("k.json", config(keys))}).messages;
    CHECK_THAT(said, Contains("/key100000: ") && Contains("/key100019: ") && !Contains("/key100020: ") &&
                         Contains(": 4980 more errors"));
}
