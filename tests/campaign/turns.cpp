// SPDX-License-Identifier: BSD-3-Clause
//
// Torsion springs as a user writes them in configs and reads them in results: closed forms at the end, turns in final
// states and samples, and the message of a run that has lost them.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"
#include "records/json/writer.hpp"
#include "support/errors.hpp"
#include "tests/campaign/acceptance.hpp"

using namespace kreisel;
using Catch::Contains;
using nlohmann::ordered_json;

namespace {

const Engines engines_of_turns{engine_binary64(), engine_binary64()};

/// A wheel of unit inertia on a hinge with a spring of 4 N m/rad, at `rate` rad/s.
ordered_json sprung_wheel(double rate, const std::string& more_of_the_spring = "") {
    ordered_json parameters = ordered_json::parse(R"({"gravity": [0, 0, 0],
        "bodies": [{"name": "wheel", "mass": 1, "inertia": [1, 1, 1], "x": [0, 0, 0]}],
        "joints": [{"type": "revolute", "between": ["ground", "wheel"], "point": [0, 0, 0], "axis": [0, 0, 1]}],
        "forces": [{"type": "torsion_spring", "between": ["ground", "wheel"], "axis": [0, 0, 1], "stiffness": 4)" +
                                                  more_of_the_spring + "}]}");
    parameters["bodies"][0]["omega"] = {0, 0, rate};
    return parameters;
}

Plan plan_with(const ordered_json& parameters, double end, long steps, long samples = 0) {
    ordered_json config = {{"name", "turns"}, {"kind", "trajectory"}};
    config["methods"] = {
        "rkmk/rk4",          "crouch_grossman/cg4a",   "rkmk/implicit_midpoint", "generalized_alpha/index2",
        "multistep/bliedf2", "baseline/rk4_quaternion"};
    config["problems"] = {{{"name", "multibody"}, {"parameters", parameters}}};
    config["formulations"] = {"SO3xR3", "SE3", "S3xR3"};
    config["time"] = {{"end", end}, {"steps", steps}};
    config["output"] = {{"samples", samples}};
    return plan_of(parse_document("turns.json", config.dump(1)), engines_of_turns);
}

void check_end(const ordered_json& parameters, double end, double omega, double theta, long turns) {
    int cells = 0;
    for (const PlannedCell& planned : plan_with(parameters, end, 4000).cells) {
        if (!planned.skip_reason().empty()) continue;
        INFO(planned.cell().method << " on " << planned.cell().formulation);
        const Outcome outcome = engine_binary64().run(planned.cell(), nullptr, {});
        REQUIRE(outcome.status == "ok");
        const double allowed = planned.cell().method.find("4") != std::string::npos ? 1e-8 : 1e-3;
        CHECK(std::abs(outcome.final->bodies[0].omega[2].value - omega) < allowed);
        CHECK(std::abs(outcome.final->theta.at(0).value - theta) < allowed);
        CHECK(outcome.final->turns == std::vector<long>{turns});
        ++cells;
    }
    CHECK(cells >= 16);
}

}  // namespace

TEST_CASE("a torsion spring pulls on past half a turn", "[campaign]") {
    check_end(sprung_wheel(10), 2, 10 * std::cos(4), 5 * std::sin(4), -1);
}

TEST_CASE("the rest angle of a torsion spring may be any number", "[campaign]") {
    check_end(sprung_wheel(0, R"(, "angle": 20)"), 1, 40 * std::sin(2), 20 - 20 * std::cos(2), 5);
}

TEST_CASE("turns are read at a start", "[campaign]") {
    check_end(sprung_wheel(0, R"(, "turns": -3)"), 1, 12 * M_PI * std::sin(2), -6 * M_PI * std::cos(2), 1);
    try {
        plan_with(sprung_wheel(0, R"(, "turns": 1.5)"), 1, 10);
        FAIL("one and a half turns are accepted");
    } catch (const UsageError& error) {
        CHECK_THAT(error.what(), Contains("/problems/0/parameters/forces/0/turns") && Contains("whole number"));
    }
    const Plan plan = plan_with(sprung_wheel(0, R"(, "turns": -3)"), 1, 10);
    CHECK_THAT(json_value(plan.cells[0].cell().parameters), Contains(R"("turns":-3)"));
}

TEST_CASE("samples hold angle and turns of each torsion spring", "[campaign]") {
    const Plan plan = plan_with(sprung_wheel(10), 2, 400, 4);
    acceptance::Samples samples;
    engine_binary64().run(plan.cells[0].cell(), nullptr, {}, &samples);
    std::size_t theta = 0, turns = 0;
    for (std::size_t i = 0; i < samples.columns.size(); ++i) {
        const Column& column = samples.columns[i];
        if (column.name == "theta.ground-wheel" && column.unit == "rad") theta = i;
        if (column.name == "turns.ground-wheel" && column.unit == "1") turns = i;
    }
    REQUIRE(theta > 0);
    REQUIRE(turns == theta + 1);
    REQUIRE(samples.rows.size() == 5);
    for (std::size_t row = 0; row < 5; ++row) {
        const auto values = ordered_json::parse("[" + samples.rows[row] + "]");
        const double expected = 5 * std::sin(static_cast<double>(row));
        CHECK(std::abs(values[theta].get<double>() - expected) < 1e-6);
        CHECK(values[turns].get<double>() == std::round(expected / (2 * M_PI)));
    }
}

TEST_CASE("energy is conserved by a spring that turns often", "[campaign]") {
    Plan plan = plan_with(sprung_wheel(100), 10, 20000);
    Cell cell = plan.cells[0].cell();
    cell.metrics = {"invariant.energy*"};
    const Outcome outcome = engine_binary64().run(cell, nullptr, {});
    REQUIRE(outcome.status == "ok");
    bool measured = false;
    for (const auto& [name, value] : outcome.metrics)
        if (name == "invariant.energy.relative") measured = value.value < 1e-9;
    CHECK(measured);
}

TEST_CASE("a run that loses a turn says when, which spring and why", "[campaign]") {
    const Plan plan = plan_with(sprung_wheel(0, R"(, "angle": 20)"), 1, 12);
    for (const PlannedCell& planned : plan.cells) {
        if (!planned.skip_reason().empty() || planned.cell().method != "rkmk/rk4") continue;
        const Outcome outcome = engine_binary64().run(planned.cell(), nullptr, {});
        CHECK(outcome.status == "turn_lost");
        CHECK_THAT(outcome.detail, Contains("from t = 0.") && Contains("torsion spring 0 (ground - wheel)"));
        CHECK_FALSE(outcome.final);
    }
}
