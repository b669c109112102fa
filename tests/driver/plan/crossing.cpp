// SPDX-License-Identifier: BSD-3-Clause
//
// From the axes of a config to its cells.
#include <array>
#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "driver/config/resolved.hpp"
#include "tests/driver/plan/planned.hpp"

namespace kreisel::plan_tests {

TEST_CASE("a wildcard stands for all methods, or for those of a family") {
    const auto planned = [](const std::string& methods) {
        const Plan plan = plan_from(R"({"name": "n", "kind": "drift", "problems": ["heavy_top"], "methods": )" +
                                    methods + R"(, "time": {"end": 2, "steps": 4}})");
        std::set<std::string> names;
        for (const PlannedCell& cell : plan.cells) { names.insert(cell.cell().method); }
        return names;
    };
    CHECK(planned(R"(["rkmk/*"])") == std::set<std::string>{"rkmk/rk4", "rkmk/midpoint"});
    CHECK(planned(R"(["*"])").size() == plain_engine.methods().size());
    CHECK_THROWS_WITH(planned(R"(["*", "rkmk/rk4"])"), Catch::Contains("each method once"));
    CHECK_THROWS_WITH(planned(R"(["rkmc/*"])"), Catch::Contains("method"));
}

TEST_CASE("every axis is crossed with every other, the steps varying fastest") {
    const Plan plan = plan_from(R"({"name": "n", "kind": "drift", "precision": ["double", "quad"],
        "problems": ["heavy_top", "double_pendulum"], "formulations": ["SO3xR3", "SE3"],
        "methods": [{"name": "rkmk/rk4", "dexpinv": ["exact", 0, "seed"]}, "rkmk/midpoint"],
        "projections": ["none", {"name": "terze", "weight": ["mass", "identity"]}],
        "time": {"end": 1, "steps": [4, 2]}})");
    REQUIRE(plan.cells.size() == 2 * 2 * 2 * 4 * 3 * 2);
    CHECK(plan.cells[0].cell().steps == 4);
    CHECK(plan.cells[1].cell().steps == 2);
    CHECK(plan.cells[2].precision() == "quad");
    CHECK(plan.cells[4].cell().projection_options.at("weight") == OptionValue("mass"));
    CHECK(plan.cells[12].cell().options.at("dexpinv") == OptionValue(0L));
    CHECK(plan.cells[48].cell().formulation == "SE3");
    CHECK(plan.cells[96].cell().problem == "double_pendulum");
    std::set<std::string> hashes;
    for (const PlannedCell& cell : plan.cells) {
        CHECK(std::regex_match(cell.hash(), std::regex("[0-9a-f]{16}")));
        hashes.insert(cell.hash());
    }
    CHECK(hashes.size() == plan.cells.size());
    CHECK(plan.references.empty());  // drift measures no error
}

TEST_CASE("defaults are those of the contract") {
    const Plan plan = plan_from(one_cell("\"heavy_top\"", ""));
    const Cell& cell = plan.cells.front().cell();
    CHECK(cell.formulation == "SO3xR3");
    CHECK(cell.projection == "none");
    CHECK(plan.cells.front().precision() == "double");
    CHECK(cell.samples == 0);
    CHECK(cell.metrics == std::vector<std::string>{"defect.*", "invariant.*"});
    CHECK(std::get<double>(cell.parameters.at("mass")) == 15);
    CHECK(cell.options.at("coordinates") == OptionValue("exp"));
}

TEST_CASE("the time grid in its four spellings") {
    const auto steps = [](const std::string& time) {
        return plan_from(
                   R"({"name": "n", "kind": "drift", "problems": ["heavy_top"], "methods": ["rkmk/rk4"], "time": )" +
                   time + "}")
            .config.steps;
    };
    CHECK(steps(R"({"end": 1, "steps": 7})") == std::vector<long>{7});
    CHECK(steps(R"({"end": 1, "steps": [7, 3]})") == std::vector<long>{7, 3});
    CHECK(steps(R"({"end": 1, "steps": {"from": 5, "levels": 3}})") == std::vector<long>{5, 10, 20});
    CHECK(steps(R"({"end": 1, "steps": {"from": 5, "levels": 3, "factor": 10}})") == std::vector<long>{5, 50, 500});
    CHECK(steps(R"({"end": 1, "step": [0.1, 0.001]})") == std::vector<long>{10, 1000});
    CHECK(steps(R"({"end": 0.3, "step": 0.1})") == std::vector<long>{3});  // 0.3/0.1 is not an integer in double
}

TEST_CASE("a number given as a list is an axis of the problem") {
    const Plan plan =
        plan_from(R"({"name": "n", "kind": "drift", "methods": ["rkmk/rk4"], "time": {"end": 1, "steps": 4},
        "problems": [{"name": "heavy_top", "label": "top", "parameters": {"mass": [3, 1.5, 2]}}, "free_top",
                     {"name": "heavy_top", "parameters": {"mass": [7]}}]})");
    REQUIRE(plan.cells.size() == 5);
    const std::array<std::string, 5> labels = {"top, mass = 3", "top, mass = 1.5", "top, mass = 2", "free_top",
                                               "heavy_top"};
    for (std::size_t i = 0; i < labels.size(); ++i) { CHECK(plan.cells[i].label() == labels[i]); }
    CHECK(plan.cells[1].series() == "top");
    CHECK(plan.cells[3].series() == "free_top");
    CHECK(plan.cells[1].cell().parameters.at("mass") == ParameterValue(1.5));
    CHECK(plan.cells[1].identity().label == "top, mass = 1.5");
    CHECK(plan.cells[1].identity().series == "top");
    CHECK(plan.cells[3].identity().series == plan.cells[3].identity().label);

    const Plan again = plan_from(resolved_config(plan.config));
    REQUIRE(again.cells.size() == plan.cells.size());
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        CHECK(again.cells[i].identity() == plan.cells[i].identity());
    }
}

TEST_CASE("a parameter of any kind can be an axis, and axes can vary together") {
    const Plan plan = plan_from(R"({"name": "n", "kind": "drift", "methods": ["rkmk/rk4"],
        "time": {"end": 1, "steps": 4}, "problems": [{"name": "heavy_top", "label": "top", "parameters": {
            "lever": {"axis": [[0, 0, 1], [0, 0, 2]], "zip": "size"}, "mass": {"axis": [1, 8], "zip": "size"},
            "R": {"axis": [[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, -1, 0], [1, 0, 0], [0, 0, 1]]]}}}]})");
    REQUIRE(plan.cells.size() == 4);
    const std::string identity = "[[1,0,0],[0,1,0],[0,0,1]]", turned = "[[0,-1,0],[1,0,0],[0,0,1]]";
    const auto label = [](const std::string& mass, const std::string& lever, const std::string& R) {
        return "top, mass = " + mass + ", lever = " + lever + ", R = " + R;
    };
    CHECK(plan.cells[0].label() == label("1", "[0,0,1]", identity));
    CHECK(plan.cells[1].label() == label("1", "[0,0,1]", turned));
    CHECK(plan.cells[2].label() == label("8", "[0,0,2]", identity));
    CHECK(plan.cells[3].label() == label("8", "[0,0,2]", turned));
    CHECK(plan.cells[3].cell().parameters.at("mass") == ParameterValue(8.0));
    CHECK(plan.cells[3].cell().parameters.at("lever") == ParameterValue(Vector3{0, 0, 2}));
    const Plan again = plan_from(resolved_config(plan.config));
    REQUIRE(again.cells.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) { CHECK(again.cells[i].identity() == plan.cells[i].identity()); }
}

TEST_CASE("an axis alone in its zip gives a warning, and is crossed") {
    const auto plan_of_zips = [](const std::string& of_mass, const std::string& of_lever) {
        return plan_from(R"({"name": "n", "kind": "drift", "methods": ["rkmk/rk4"], "time": {"end": 1, "steps": 4},
            "problems": [{"name": "heavy_top", "parameters": {
                "mass": {"axis": [1, 8], "zip": ")" +
                         of_mass + R"("},
                "lever": {"axis": [[0, 0, 1], [0, 0, 2]], "zip": ")" +
                         of_lever + "\"}}}]}");
    };
    CHECK(plan_of_zips("size", "size").warnings.empty());
    const Plan lonely = plan_of_zips("size", "sizes");
    CHECK(lonely.cells.size() == 4);
    CHECK(lonely.warnings ==
          std::vector<std::string>{"/problems/0/parameters/mass: no other axis here has the zip \"size\": this one is "
                                   "crossed with the others",
                                   "/problems/0/parameters/lever: no other axis here has the zip \"sizes\": this one "
                                   "is crossed with the others"});
}

TEST_CASE("lists of bodies on an axis are told apart by their numbers") {
    const auto bodies = [](double mass) {
        return fmt::format(R"([{{"name": "a", "mass": {}, "inertia": [1, 1, 1], "x": [0, 0, 0]}}])", mass);
    };
    const Plan plan = plan_from(R"({"name": "n", "kind": "drift", "methods": ["rkmk/rk4"],
        "time": {"end": 1, "steps": 4}, "problems": [{"name": "multibody", "parameters": {
            "bodies": {"axis": [)" +
                                bodies(1) + ", " + bodies(2) + "]}}}]}");
    REQUIRE(plan.cells.size() == 2);
    CHECK(plan.cells[0].label() == "multibody, bodies = #1");
    CHECK(plan.cells[1].label() == "multibody, bodies = #2");
    CHECK(plan_from(resolved_config(plan.config)).warnings.empty());
}

TEST_CASE("what does not apply is skipped with the reason") {
    const Plan plan =
        plan_from(R"({"name": "n", "kind": "drift", "problems": ["double_pendulum"], "formulations": ["SE3", "SO3"],
        "methods": ["baseline/rk4_quaternion"], "time": {"end": 1, "steps": 4}})");
    REQUIRE(plan.cells.size() == 2);
    CHECK(plan.cells[0].skip_reason().find("own their coordinates") != std::string::npos);
    CHECK(plan.cells[1].skip_reason().find("fixed point") != std::string::npos);
    REQUIRE(plan.warnings.size() == 1);
    CHECK(plan.warnings.front().find("every cell of this config is skipped") != std::string::npos);
}

TEST_CASE("a reference is planned once for each problem, and only where errors are asked for") {
    CHECK(plan_from(good_config()).references.size() == 1);
    CHECK(plan_from(one_cell("\"heavy_top\"", R"(, "metrics": ["error.rotation"])")).references.size() == 1);
    CHECK(plan_from(one_cell("\"heavy_top\"", R"(, "metrics": ["*.position"])")).references.size() == 1);
    CHECK(plan_from(one_cell("\"heavy_top\"", R"(, "metrics": ["defect.position"])")).references.empty());
    const auto of_samples = [&](const std::string& metric, const std::string& output) {
        return plan_from(one_cell("\"heavy_top\"", R"(, "metrics": [")" + metric + "\"]" + output));
    };
    const std::string two = R"(, "output": {"samples": 2})";
    const auto samples_of = [](const Plan& plan) { return plan.references.at(plan.cells.at(0).reference()).samples; };
    CHECK(samples_of(of_samples("error.*", two)) == 2);
    CHECK(samples_of(of_samples("error.rotation.max", two)) == 2);
    CHECK(samples_of(of_samples("error.rotation", two)) == 0);
    CHECK(of_samples("error.rotation", two).cells[0].reference() == of_samples("error.*", "").cells[0].reference());
    CHECK(of_samples("error.rotation", two).cells[0].reference() != of_samples("error.*", two).cells[0].reference());
    const Plan without = of_samples("error.rotation.max", "");
    CHECK(without.references.empty());
    REQUIRE(without.warnings.size() == 1);
    CHECK_THAT(without.warnings[0], Catch::Contains("fits no metric that a cell of this config can measure"));
}

}  // namespace kreisel::plan_tests
