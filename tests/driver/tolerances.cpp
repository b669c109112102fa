// SPDX-License-Identifier: BSD-3-Clause
//
// Steps to tolerances: what a config says of them, which cells it makes, what their results tell.
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "driver/config/resolved.hpp"
#include "driver/plan/plan.hpp"
#include "records/cell/line.hpp"
#include "records/cell/read_table.hpp"
#include "records/cell/stepping.hpp"
#include "records/diff/recorded_cell.hpp"
#include "records/json/strict.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

std::string stepped_config(const std::string& methods, const std::string& time, const std::string& rest = "",
                           const std::string& kind = "convergence") {
    return R"({"name": "n", "kind": ")" + kind + R"(", "problems": ["heavy_top"], "methods": )" + methods +
           R"(, "time": {"end": 2, )" + time + "}" + rest + "}";
}

Plan stepped_plan(const std::string& methods, const std::string& time, const std::string& rest = "") {
    return plan_of(parse_document("test.json", stepped_config(methods, time, rest)), one_engine);
}

std::vector<double> tolerances_of(const std::string& time) {
    return stepped_plan(R"(["fake/pair"])", time).config.tolerances;
}

// "rkmk/rk4 8 steps" and "fake/pair tolerance 0.001", with the reasons of those that are skipped.
std::set<std::string> stepped_cells(const Plan& plan) {
    std::set<std::string> cells;
    for (const PlannedCell& planned : plan.cells) {
        cells.insert(planned.cell().method + " " + stepping_text(planned.cell()) +
                     (planned.skip_reason().empty() ? "" : ": " + planned.skip_reason()));
    }
    return cells;
}

const std::string priced = stepped_config(R"(["rkmk/rk4", "fake/pair", "fake/own"])",
                                          R"("steps": [4, 8, 16], "tolerance": {"from": 1e-2, "levels": 5})",
                                          R"(, "output": {"samples": 2})", "work_precision");

}  // namespace

TEST_CASE("a tolerance is a number, a list, or a geometric sequence of exact decimals") {
    CHECK(tolerances_of(R"("tolerance": 1e-6)") == std::vector<double>{1e-6});
    CHECK(tolerances_of(R"("tolerance": [1e-3, 0.5, 1e-9])") == std::vector<double>{1e-3, 0.5, 1e-9});
    CHECK(tolerances_of(R"("tolerance": {"from": 1e-2, "levels": 8})") ==
          std::vector<double>{1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9});
    CHECK(tolerances_of(R"("tolerance": {"from": 0.3, "levels": 3, "factor": 100})") ==
          std::vector<double>{0.3, 0.003, 0.00003});
    CHECK(tolerances_of(R"("steps": 4)").empty());
}

TEST_CASE("a method has cells for those steps and tolerances that it takes") {
    const std::string steps = R"("steps": [4, 8])", tolerance = R"("tolerance": [0.01])";
    const std::string all = R"(["rkmk/rk4", "fake/pair", "fake/own"])";
    CHECK(stepped_cells(stepped_plan(all, steps + ", " + tolerance)) ==
          std::set<std::string>{"rkmk/rk4 4 steps", "rkmk/rk4 8 steps", "fake/pair 4 steps", "fake/pair 8 steps",
                                "fake/pair tolerance 0.01", "fake/own tolerance 0.01"});
    const std::string by_itself = ": it chooses its steps itself, to a tolerance";
    CHECK(stepped_cells(stepped_plan(all, steps)) ==
          std::set<std::string>{"rkmk/rk4 4 steps", "rkmk/rk4 8 steps", "fake/pair 4 steps", "fake/pair 8 steps",
                                "fake/own 4 steps" + by_itself, "fake/own 8 steps" + by_itself});
    CHECK(stepped_cells(stepped_plan(all, tolerance)) ==
          std::set<std::string>{
              "rkmk/rk4 tolerance 0.01: it has no estimate of its error to choose steps by: constant steps only",
              "fake/pair tolerance 0.01", "fake/own tolerance 0.01"});
}

TEST_CASE("samples need to divide constant steps only") {
    CHECK(stepped_plan(R"(["fake/pair"])", R"("tolerance": 0.01)", R"(, "output": {"samples": 7})").cells.size() == 1);
    CHECK_THROWS_WITH(
        stepped_plan(R"(["fake/pair"])", R"("steps": 4, "tolerance": 0.01)", R"(, "output": {"samples": 3})"),
        Catch::Contains("divides every number of steps"));
}

TEST_CASE("what decides the steps decides the hash, and what has no say in it does not") {
    const auto hash = [](const std::string& time, const std::string& rest = "") {
        return stepped_plan(R"(["fake/pair"])", time, rest).cells.at(0).hash();
    };
    const std::string one = hash(R"("tolerance": 0.01)");
    CHECK(one == hash(R"("tolerance": [0.01], "controller": "pi")"));
    CHECK(one == hash(R"("tolerance": 0.01)", R"(, "output": {"dense": false})"));  // there are no samples
    CHECK(one != hash(R"("tolerance": 0.02)"));
    CHECK(one != hash(R"("tolerance": 0.01, "controller": "pid")"));
    const std::string sampled = hash(R"("tolerance": 0.01)", R"(, "output": {"samples": 2})");
    CHECK(sampled != hash(R"("tolerance": 0.01)", R"(, "output": {"samples": 2, "dense": false})"));
    const std::string constant = hash(R"("steps": 4)", R"(, "output": {"samples": 2})");
    CHECK(constant == hash(R"("steps": 4)", R"(, "output": {"samples": 2, "dense": false})"));
    CHECK(constant == hash(R"("steps": 4, "tolerance": 0.01)", R"(, "output": {"samples": 2})"));
}

TEST_CASE("a config with tolerances, resolved, leads to the same cells") {
    const Plan plan = plan_of(parse_document("test.json", priced), one_engine);
    const Plan again = plan_of(parse_document("again.json", resolved_config(plan.config)), one_engine);
    REQUIRE(again.cells.size() == 3 + 3 + 5 + 5);
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        CHECK(again.cells[i].identity() == plan.cells[i].identity());
        CHECK(again.cells[i].hash() == plan.cells[i].hash());
        CHECK(again.cells[i].cell().repeated);
    }
}

TEST_CASE("the line of a cell to a tolerance tells it in place of steps, and reads back") {
    const Plan plan = stepped_plan(R"(["fake/pair", "rkmk/rk4"])", R"("steps": 8, "tolerance": 1e-6)");
    const auto line_of = [&](std::size_t i) {
        return result_text(record_of(plan.cells[i], plain_engine.run(plan.cells[i].cell(), nullptr, {}), nullptr));
    };
    const auto adaptive = nlohmann::json::parse(line_of(1)), constant = nlohmann::json::parse(line_of(0));
    CHECK(adaptive.at("tolerance") == 1e-6);
    CHECK(adaptive.at("controller") == "pi");
    CHECK_FALSE(adaptive.contains("steps"));
    CHECK_FALSE(adaptive.contains("h"));
    CHECK(adaptive.at("cost").at("accepted") == 316);
    CHECK(adaptive.at("cost").at("rejected") == 39);
    CHECK(adaptive.at("cost").at("brackets") == 316);
    CHECK(constant.at("steps") == 8);
    CHECK_FALSE(constant.contains("tolerance"));
    CHECK(constant.at("cost").size() == 3);  // results of other kinds have the counts that they always had
    CHECK(read_record(line_of(1)).identity == plan.cells[1].identity());
    CHECK(read_record(line_of(0)).identity == plan.cells[0].identity());
    CHECK(read_recorded_cell(line_of(1)).identity.at("tolerance") == "1e-06");
    CHECK_FALSE(read_recorded_cell(line_of(1)).identity.contains("steps"));
}

TEST_CASE("times of a work_precision experiment are in the journal, its results are the same bytes again") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", priced);
    const std::string a = (scratch / "a").string(), b = (scratch / "b").string();
    REQUIRE(run_program({"run", config, "-o", a, "-j", "4"}).code == 0);
    REQUIRE(run_program({"run", config, "-o", b, "-j", "1"}).code == 0);
    const std::string results = contents(scratch / "a" / "results.jsonl");
    CHECK(results == contents(scratch / "b" / "results.jsonl"));
    CHECK(contents(scratch / "a" / "results.csv") == contents(scratch / "b" / "results.csv"));
    CHECK(results.find("run_s") == std::string::npos);
    std::istringstream journal(contents(scratch / "a" / "journal.jsonl"));
    std::size_t lines = 0;
    std::map<std::string, double> first_round;
    for (std::string line; std::getline(journal, line); ++lines) {
        const auto cost = nlohmann::json::parse(line).at("cost");
        CHECK(cost.at("run_s").get<double>() > 0);
        CHECK(cost.contains("exponentials"));
        const CellRecord cell = read_journal_line(line, nlohmann::json::parse(line).at("build")).value();
        CHECK(cell.times.run_s == cost.at("run_s"));
        const auto [earlier, first] = first_round.emplace(cell.identity.cell, *cell.times.run_s);
        if (!first) { CHECK(*cell.times.run_s < earlier->second); }  // the second line, after all rounds
    }
    CHECK(lines == 2 * 16);
    CHECK(first_round.size() == 16);
    const auto table = read_results_table(contents(scratch / "a" / "results.csv"));
    REQUIRE(table.size() == 16);
    CHECK(table.at(0).identity.steps == 4);
    CHECK(table.at(15).identity.tolerance == 1e-6);
    CHECK(table.at(15).identity.controller == "pi");
    CHECK(run_program({"verify", a}).code == 0);
    CHECK(run_program({"diff", a, b}).code == 0);
}

TEST_CASE("times are taken in rounds, all cells in each, and not again when a run is resumed") {
    const ScratchFolder scratch;
    const FakeEngine engine;
    const std::string config = scratch.file(
        "c.json", stepped_config(R"(["rkmk/rk4", "fake/nan"])", R"("steps": [4, 8, 16])", "", "work_precision"));
    const std::string out = (scratch / "a").string();
    run_program({"run", config, "-o", out, "-j", "4"}, engine);
    REQUIRE(engine.timed.size() == 3 * (timing_rounds - 1));  // what fails has no time
    for (std::size_t i = 0; i < engine.timed.size(); ++i) { CHECK(engine.timed[i] == engine.timed[i % 3]); }
    CHECK(std::set<long>(engine.timed.begin(), engine.timed.end()).size() == 3);
    run_program({"run", config, "-o", out, "--resume"}, engine);
    CHECK(engine.timed.size() == 3 * (timing_rounds - 1));
}

TEST_CASE("two tolerances are two cells to a comparison") {
    const ScratchFolder scratch;
    const auto run = [&](const std::string& name, const std::string& tolerances) {
        const std::string text = stepped_config(R"(["fake/pair"])", "\"tolerance\": " + tolerances);
        const std::string config = scratch.file(name + ".json", text);
        REQUIRE(run_program({"run", config, "-o", (scratch / name).string()}).code == 0);
    };
    run("a", "[1e-3, 1e-4]"), run("b", "[1e-4, 1e-5]");
    const ProgramResult result = run_program({"diff", (scratch / "a").string(), (scratch / "b").string()});
    CHECK(result.code == 1);
    CHECK_THAT(result.out, Catch::Contains("to 0.001 by pi") && Catch::Contains("to 1e-05 by pi"));
    CHECK(result.out.find("to 0.0001 by pi") == std::string::npos);
}

TEST_CASE("plan and info tell tolerances") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", stepped_config(R"(["fake/pair"])", R"("tolerance": 1e-6)"));
    CHECK_THAT(run_program({"plan", config}).out, Catch::Contains("to 1e-06"));
    CHECK_THAT(run_program({"info", "fake/pair"}).out, Catch::Contains("error estimate O(h^4)"));
    CHECK_THAT(run_program({"info", "fake/own"}).out, Catch::Contains("to a tolerance only"));
    CHECK_THAT(run_program({"info", "rkmk/rk4"}).out, !Catch::Contains("tolerance"));
    CHECK_THAT(run_program({"info", "work_precision"}).out, Catch::Contains("run one at a time, and again"));
}
