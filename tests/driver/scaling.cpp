// SPDX-License-Identifier: BSD-3-Clause
//
// Values that differ from run to run are only in the journal.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "records/cell/line.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

TEST_CASE("times of a scaling experiment are in the journal, its results are the same bytes again") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", R"({"name": "s", "kind": "scaling", "methods": ["rkmk/rk4"],
        "problems": [{"name": "heavy_top", "parameters": {"mass": [1, 2, 3]}}], "time": {"end": 1, "steps": 4}})");
    REQUIRE(run_program({"run", config, "-o", (scratch / "a").string(), "-j", "4"}).code == 0);
    REQUIRE(run_program({"run", config, "-o", (scratch / "b").string(), "-j", "1"}).code == 0);
    const std::string results = contents(scratch / "a" / "results.jsonl");
    REQUIRE(!results.empty());
    CHECK(results == contents(scratch / "b" / "results.jsonl"));
    CHECK(contents(scratch / "a" / "results.csv") == contents(scratch / "b" / "results.csv"));
    CHECK(results.find("step_s") == std::string::npos);
    CHECK(results.find("\"final\"") == std::string::npos);
    CHECK(results.find("\"bodies\":1") != std::string::npos);
    std::istringstream journal(contents(scratch / "a" / "journal.jsonl"));
    for (std::string line; std::getline(journal, line);) {
        const auto cost = nlohmann::json::parse(line).at("cost");
        CHECK(cost.at("step_s").get<double>() > 1e-6);
        CHECK(cost.at("memory") == 1000);
        CHECK(read_journal_line(line, nlohmann::json::parse(line).at("build"))->times.step_s == cost.at("step_s"));
    }
}
