// SPDX-License-Identifier: BSD-3-Clause
//
// What decides a cell's hash: its numbers, however they are written, and nothing else.
#include <catch2/catch.hpp>

#include "driver/config/resolved.hpp"
#include "support/hash.hpp"
#include "tests/driver/plan/planned.hpp"

namespace kreisel::plan_tests {

namespace {

std::string hash_of(const std::string& text) {
    const Plan plan = plan_from(text);
    REQUIRE(plan.cells.size() == 1);
    return plan.cells.front().hash();
}

}  // namespace

TEST_CASE("a cell's name depends on what decides its numbers and on nothing else") {
    const std::string name = hash_of(one_cell("\"heavy_top\"", ""));
    CHECK(name ==
          "c64bbc55218c5760");  // changes only with the definition of the hash: results must then be computed again
    // order of keys, spelling of numbers, defaults written out, labels
    CHECK(name == hash_of(R"({"time": {"steps": 4, "end": 2.0}, "methods": [{"dexpinv": "exact", "name": "rkmk/rk4"}],
                             "problems": [{"parameters": {"mass": 1.5e1}, "label": "other", "name": "heavy_top"}],
                             "kind": "drift", "name": "another", "precision": "double", "projections": ["none"],
                             "metrics": ["invariant.*", "defect.*"], "output": {"samples": 0}})"));
    // everything else changes it
    for (const char* rest : {R"(, "precision": "quad")", R"(, "formulations": ["SE3"])",
                             R"(, "projections": ["terze"])", R"(, "metrics": [])", R"(, "output": {"samples": 2})"}) {
        CHECK(name != hash_of(one_cell("\"heavy_top\"", rest)));
    }
    CHECK(name != hash_of(one_cell("\"free_top\"", "")));
    CHECK(name != hash_of(one_cell(R"({"name": "heavy_top", "parameters": {"mass": 15.000000000000002}})", "")));
}

TEST_CASE("the hash is FNV-1a of 64 bits") {
    CHECK(hash_text("") == "cbf29ce484222325");
    CHECK(hash_text("a") == "af63dc4c8601ec8c");
    CHECK(hash_text("foobar") == "85944171f73967e8");
    CHECK(hash64("bar", hash64("foo")) == hash64("foobar"));
}

TEST_CASE("numbers and rows have one text, however they are written, and the cell's hash and order know it") {
    const auto planned = [](const std::string& options) {
        return plan_from(R"({"name": "n", "kind": "drift", "problems": ["heavy_top"], "methods": [{"name": )"
                         R"("fake/tableau", )" +
                         options + R"(}], "time": {"end": 2, "steps": 4}})");
    };
    const Plan lists = planned(R"("a": [[], ["1/2"], [0, "-0.25"]], "b": [1, "2/3"], "order": 3)");
    REQUIRE(lists.cells.size() == 1);
    const PlannedCell& cell = lists.cells.front();
    CHECK(cell.cell().options.at("a") == OptionValue("; 1/2; 0 -0.25"));
    CHECK(cell.cell().options.at("b") == OptionValue("1 2/3"));
    CHECK(cell.identity().order == Order(3));
    CHECK(planned(R"("a": " ;1/2;  0 -0.25 ", "b": "1  2/3", "order": 3)").cells.front().hash() == cell.hash());
    CHECK(planned(R"("a": "; 1/2; 0 -0.25", "b": "1 1/3", "order": 3)").cells.front().hash() != cell.hash());
    const std::string resolved = resolved_config(lists.config);
    CHECK(plan_from(resolved).cells.front().hash() == cell.hash());
}

TEST_CASE("an inertia may be written as three numbers or as a matrix") {
    CHECK(hash_of(one_cell(R"({"name": "heavy_top", "parameters": {"inertia": [1, 2, 2]}})", "")) ==
          hash_of(
              one_cell(R"({"name": "heavy_top", "parameters": {"inertia": [[1, 0, 0], [0, 2, 0], [0, 0, 2]]}})", "")));
}

TEST_CASE("a whole number is the same however it is written") {
    const auto planned = [](const std::string& count, const std::string& options) {
        return plan_from(R"({"name": "n", "kind": "drift", "problems": ["heavy_top"],
            "methods": [{"name": "rkmk/rk4")" +
                         options + R"(}], "time": {"end": 1, "steps": )" + count + "}}");
    };
    const Plan plain = planned("2000", R"(, "dexpinv": 3)");
    for (const std::string count : {"2000.0", "2e3", "[2E+3]"}) {
        const Plan plan = planned(count, R"(, "dexpinv": 3.0)");
        CHECK(plan.cells.front().hash() == plain.cells.front().hash());
        CHECK(resolved_config(plan.config) == resolved_config(plain.config));
    }
    CHECK_THAT(resolved_config(plain.config), Catch::Contains(R"("steps":[2000])"));
    CHECK_THROWS_WITH(planned("2000.5", ""), Catch::Contains("(a whole number from 1 to 1000000000), got 2000.5"));
    CHECK_THROWS_WITH(planned("[2, 2.0]", ""), Catch::Contains("each number of steps once"));
}

TEST_CASE("timed cells differ from those that are not timed") {
    const auto planned = [](const std::string& kind) {
        return plan_from(R"({"name": "n", "kind": ")" + kind + R"(", "problems": ["heavy_top"], "methods": ["rkmk/rk4"],
                             "metrics": [], "time": {"end": 1, "steps": 4}})")
            .cells.at(0);
    };
    CHECK(planned("scaling").cell().timed);
    CHECK_FALSE(planned("drift").cell().timed);
    CHECK(planned("scaling").hash() != planned("drift").hash());
}

TEST_CASE("a resolved config is a config and leads to the same cells") {
    const Plan plan = plan_from(R"({"name": "n", "kind": "drift", "precision": ["double", "quad"], "description": "d",
        "problems": ["heavy_top", {"name": "double_pendulum", "label": "l", "parameters": {"bodies": [
            {"name": "a", "mass": 0.1, "inertia": [1, 1, 1], "x": [0, 0, 1e-7], "v": [1, 2, 3]},
            {"name": "b", "mass": 3, "inertia": [1, 1, 1], "x": [0, 0, 1]}]}}],
        "methods": [{"name": "rkmk/rk4", "dexpinv": [0, "seed"]}, {"name": "fake/relaxed", "rho": [0.1, 1]}],
        "projections": ["none", {"name": "terze", "weight": ["mass", "identity"]}],
        "time": {"end": 1, "step": 0.25}, "output": {"samples": 2}, "figure": {"kind": "components",
            "quantity": "v"}})");
    const Plan again = plan_from(resolved_config(plan.config));
    REQUIRE(again.cells.size() == plan.cells.size());
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        CHECK(again.cells[i].identity() == plan.cells[i].identity());
    }
    CHECK(again.config.figure == plan.config.figure);
    CHECK(resolved_config(again.config) == resolved_config(plan.config));
}

}  // namespace kreisel::plan_tests
