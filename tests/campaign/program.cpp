// SPDX-License-Identifier: BSD-3-Clause
//
// The whole program over the real engines: what it samples, what verify confirms, what its catalogue tells.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "records/reading/read_results.hpp"
#include "records/reading/trajectory_table.hpp"
#include "records/results.hpp"
#include "tests/campaign/acceptance.hpp"
#include "tests/campaign/program.hpp"

using namespace kreisel;
using namespace kreisel::acceptance;

namespace {

/// A top at rest under gravity; t_end and steps are dyadic, so that halves of a run have its step size to the last bit.
Cell swinging_top(double t_end, long steps, long samples) {
    Cell cell{.problem = "heavy_top",
              .parameters = defaults("heavy_top"),
              .formulation = "SO3xR3",
              .method = "rkmk/rk4",
              .options = {},
              .projection = "position_velocity",
              .projection_options = {},
              .t_end = t_end,
              .steps = steps,
              .samples = samples,
              .metrics = {"*"}};
    for (const MethodDescription& description : engine_binary64().methods())
        if (description.name == cell.method) cell.options = standard_options(description);
    return cell;
}

std::vector<std::string> fields(const std::string& row) {
    std::vector<std::string> all;
    std::istringstream stream(row);
    for (std::string field; std::getline(stream, field, ',');) all.push_back(field);
    return all;
}

/// t, x, R, v, omega of the one body as a trajectory writes them.
std::vector<std::string> texts(const ReportedState& state) {
    const ReportedBody& body = state.bodies.at(0);
    std::vector<std::string> all = {state.t.text};
    const auto add = [&](const auto& numbers) {
        for (const Number& number : numbers) all.push_back(number.text);
    };
    add(body.x), add(body.R), add(body.v), add(body.omega), add(state.multipliers);
    return all;
}

}  // namespace

TEST_CASE("a sample is the state of a run that ends there", "[campaign]") {
    const Engine* const engines[] = {&engine_binary64(), &engine_binary128()};
    for (const Engine* engine : engines) {
        Samples whole;
        REQUIRE(engine->run(swinging_top(0.125, 64, 4), nullptr, {}, &whole).status == "ok");
        REQUIRE(whole.rows.size() == 5);
        const auto& columns = whole.columns;
        CHECK(columns[0].name == "t");
        CHECK(columns[4].name == "top.R11");
        CHECK(columns[18].name == "top.omega3");
        CHECK(columns[18].unit == "rad/s");
        CHECK(columns[19].name == "lambda.ground-top.1");
        for (std::size_t i = 1; i <= 4; ++i) {
            const auto part = static_cast<double>(i) / 4;
            const Outcome end = engine->run(swinging_top(0.125 * part, std::lround(64 * part), 0), nullptr, {});
            auto row = fields(whole.rows[i]);
            CHECK(row.size() == columns.size());
            auto expected = texts(end.final.value());
            row.resize(expected.size());
            CHECK(row == expected);
        }
    }
}

TEST_CASE("samples of a metric and of its running maximum end where the metric is reported", "[campaign]") {
    Samples samples;
    const Outcome outcome = engine_binary64().run(swinging_top(0.125, 64, 8), nullptr, {}, &samples);
    const auto& columns = samples.columns;
    int compared = 0;
    for (const auto& [name, value] : outcome.metrics)
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (columns[i].name != name + ".max") continue;
            CHECK(fields(samples.rows.back()).at(i) == value.text);
            ++compared;
        }
    CHECK(compared >= 5);  // three levels of constraints, orthogonality, energy
}

TEST_CASE("a run that is asked to stop is interrupted, and so is a reference", "[campaign]") {
    std::stop_source source;
    source.request_stop();
    const Cell cell = swinging_top(0.125, 64, 0);
    const Outcome outcome = engine_binary64().run(cell, nullptr, source.get_token());
    CHECK(outcome.status == "interrupted");
    CHECK(outcome.steps_done == 0);
    CHECK_FALSE(outcome.final.has_value());
    CHECK(engine_binary128().reference("heavy_top", cell.parameters, 1, source.get_token()).interrupted);
}

TEST_CASE("a projection without constraints is skipped with the reason", "[campaign]") {
    Cell cell = swinging_top(0.125, 64, 0);
    CHECK(engine_binary64().skip_reason(cell).empty());
    cell.formulation = "SO3";
    CHECK(engine_binary64().skip_reason(cell) == "there is no constraint to project onto in formulation SO3");
    cell.projection = "none";
    CHECK(engine_binary64().skip_reason(cell).empty());
}

TEST_CASE("a campaign over the real engines is run, verified and tabled", "[campaign]") {
    const Folder folder;
    const std::string config = (folder.path / "top.json").string(), out = (folder.path / "out").string();
    std::ofstream(config) << R"({"name": "top", "kind": "trajectory", "precision": ["double", "quad"],
        "problems": ["heavy_top"], "formulations": ["SO3xR3", "SO3"], "methods": ["rkmk/rk4"],
        "projections": ["none", "position_velocity"], "metrics": ["*"],
        "time": {"end": 0.125, "steps": 64}, "output": {"samples": 4}})";
    const Said run = kreisel_with({"run", config, "-o", out, "-j", "2"});
    INFO(run.messages);
    REQUIRE(run.code == 0);
    CHECK_THAT(run.messages, Catch::Contains("top: 6 ok, 2 skipped, 0 failed"));

    const Said verified = kreisel_with({"verify", out});
    CHECK(verified.code == 0);
    CHECK_THAT(verified.out, Catch::Contains("6 of 8 cells computed again (seed 1), 0 differ or are missing\n"));
    CHECK_THAT(verified.out, Catch::Contains("1 of 1 references confirmed by the second route, 0 wrong or missing\n"));

    const Results results = read_results(out);
    REQUIRE(results.rows.size() == 8);
    for (const ResultRow& row : results.rows) {
        if (!row.ok()) continue;
        INFO(row.formulation << row.projection << row.precision);
        CHECK(row.metrics.at("error.position") < 1e-3);
        CHECK(row.reference_error.at("error.position") < 1e-20);
        const TrajectoryTable trajectory = read_trajectory(row);
        const auto *x = trajectory.find("top.x1"), *y = trajectory.find("top.x2"), *z = trajectory.find("top.x3");
        REQUIRE(x != nullptr);
        REQUIRE(x->size() == 5);
        for (std::size_t i = 0; i < 5; ++i) CHECK(std::hypot((*x)[i], (*y)[i], (*z)[i]) == Approx(1).epsilon(1e-3));
    }
    CHECK(kreisel_with({"table", out}).code == 0);
    CHECK(std::filesystem::exists(std::filesystem::path(out) / "tables" / "invariants.csv"));
}

TEST_CASE("everything that is listed has its info", "[campaign]") {
    const Engine& engine = engine_binary64();
    std::vector<std::string> names;
    for (const auto& one : engine.problems()) names.push_back(one.name);
    for (const auto& one : engine.methods()) names.push_back(one.name);
    for (const auto& one : engine.projections()) names.push_back(one.name);
    for (const auto& one : engine.formulations()) names.push_back(one.name);
    const std::string listed = kreisel_with({"list"}).out;
    for (const std::string& name : names) {
        CHECK_THAT(listed, Catch::Contains("  " + name + "  "));
        const Said info = kreisel_with({"info", name});
        CHECK(info.code == 0);
        CHECK_THAT(info.out, Catch::StartsWith(name + ": "));
    }
}

TEST_CASE("a reference is not compared past its horizon, nor without a state", "[campaign]") {
    const ParameterValues values = defaults("heavy_top");
    Reference reference = engine_binary128().reference("heavy_top", values, 0.125, {});
    REQUIRE(engine_binary128().check_reference("heavy_top", values, reference).failure.empty());
    reference.horizon = 0.1;
    CHECK(engine_binary128().check_reference("heavy_top", values, reference).failure == "it lies past its horizon");
    reference.state.bodies.clear();
    reference.route = "route, stopped: here";
    CHECK(engine_binary128().check_reference("heavy_top", values, reference).failure ==
          "it has no state: route, stopped: here");
}
