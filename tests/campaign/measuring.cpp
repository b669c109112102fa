// SPDX-License-Identifier: BSD-3-Clause
//
// What could not be measured is absent: a run that becomes non-finite has no metrics, and a metric that does fails it.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <tuple>

#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"
#include "tests/campaign/program.hpp"

using namespace kreisel;
using namespace kreisel::acceptance;

namespace {

Cell cell_of(const std::string& problem, const std::string& method, double t_end, long steps) {
    Cell cell{.problem = problem,
              .parameters = defaults(problem),
              .formulation = "SO3",
              .method = method,
              .options = {},
              .projection = "none",
              .projection_options = {},
              .t_end = t_end,
              .steps = steps,
              .samples = 0,
              .metrics = {"*"}};
    for (const MethodDescription& description : engine_binary64().methods())
        if (description.name == method) cell.options = standard_options(description);
    return cell;
}

std::set<std::string> names(const Outcome& outcome) {
    std::set<std::string> all;
    for (const auto& [name, value] : outcome.metrics) all.insert(name);
    return all;
}

}  // namespace

TEST_CASE("metrics are listed by kind, place and name, and are the same in both precisions", "[campaign]") {
    const auto metrics = engine_binary64().metrics(), of_quad = engine_binary128().metrics();
    REQUIRE(metrics.size() == of_quad.size());
    REQUIRE(metrics.size() > 10);
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        const MetricDescription& metric = metrics[i];
        INFO(metric.name);
        CHECK(metric.name == of_quad[i].name);
        const std::map<MetricKind, std::string> prefixes = {
            {MetricKind::error, "error."}, {MetricKind::defect, "defect."}, {MetricKind::structure, "structure."}};
        CHECK(metric.name.starts_with(prefixes.at(metric.kind)));
        CHECK_FALSE((metric.unit.empty() || metric.symbol.empty() || metric.summary.empty()));
        const auto order = [](const MetricDescription& one) { return std::tuple(one.kind, one.place, one.name); };
        if (i > 0) { CHECK(order(metrics[i - 1]) < order(metric)); }
    }
}

TEST_CASE("an R far off SO(3) has no rotation error", "[campaign]") {
    Cell cell = cell_of("free_top", "baseline/rk4_matrix", 40, 80);
    cell.parameters["inertia"] = Matrix3{1, 0, 0, 0, 1.1, 0, 0, 0, 1.2};
    cell.parameters["omega"] = Vector3{30, 20, 10};
    const Reference reference = engine_binary128().reference("free_top", cell.parameters, 40, {});
    const Outcome outcome = engine_binary64().run(cell, &reference, {});
    CHECK_FALSE(names(outcome).contains("error.rotation"));
}

TEST_CASE("an infinite energy is not a deviation of zero", "[campaign]") {
    Cell cell = cell_of("free_top", "rkmk/rk4", 1, 10);
    cell.formulation = "SO3xR3";
    cell.parameters["mass"] = 1e300;
    cell.parameters["v"] = Vector3{1e5, 0, 0};
    const Outcome outcome = engine_binary64().run(cell, nullptr, {});
    for (const auto& [name, number] : outcome.metrics)
        if (name == "invariant.energy") CHECK_FALSE(std::isfinite(number.value));  // fails the cell
    CHECK(names(outcome).contains("invariant.energy"));
    CHECK_FALSE(names(outcome).contains("invariant.energy.relative"));
    CHECK(names(outcome).contains("defect.orthogonality"));
}

TEST_CASE("a run that fails in its first step has measured nothing", "[campaign]") {
    const Outcome outcome = engine_binary64().run(cell_of("heavy_top", "rkmk/rk4", 1, 10), nullptr, {});
    CHECK(outcome.status == "left_chart");
    CHECK(outcome.steps_done == 0);
    CHECK(outcome.metrics.empty());
    CHECK_FALSE(outcome.final.has_value());
}

TEST_CASE("a truncated dexpinv leaves its chart like the closed form", "[campaign]") {
    Cell cell = cell_of("heavy_top", "rkmk/rk4", 1, 10);
    cell.options["dexpinv"] = 2L;
    CHECK(engine_binary64().run(cell, nullptr, {}).status == "left_chart");
}

TEST_CASE("a run that has lost a first integral reports it, requested or not", "[campaign]") {
    const auto lost = [](const char* method, long steps) {
        Cell cell = cell_of("heavy_top", method, 1, steps);
        cell.metrics = {};
        return engine_binary64().run(cell, nullptr, {}).lost;
    };
    CHECK_FALSE(lost("rkmk/rk4", 2000).has_value());
    const auto vertical = lost("rkmk/euler", 16000), less = lost("rkmk/euler", 32000);
    REQUIRE(vertical.has_value());
    REQUIRE(less.has_value());
    CHECK(vertical->name == "angular_momentum_vertical");
    CHECK(vertical->share / less->share == Approx(2).epsilon(0.1));  // it falls with the order of the method
}

TEST_CASE("a metric of rows that no joint has gives a warning", "[campaign]") {
    const Engines engines{engine_binary64(), engine_binary64()};
    const auto warnings = [&](const std::string& problem, const std::string& metric) {
        const std::string config =
            R"({"name": "m", "kind": "trajectory", "methods": ["rkmk/rk4"], "projections": ["none"],
            "formulations": ["SO3xR3"], "time": {"end": 0.5, "steps": 8}, "problems": [")" +
            problem + R"("], "metrics": [")" + metric + R"("]})";
        std::size_t count = 0;
        for (const std::string& warning : plan_of(parse_document("m.json", config), engines).warnings)
            count += warning.find("/metrics/0") != std::string::npos ? 1U : 0U;
        return count;
    };
    for (const char* metric : {"defect.direction", "defect.direction.velocity", "error.multipliers.torque"}) {
        CHECK(warnings("heavy_top", metric) == 1);  // on a spherical joint
        CHECK(warnings("slider_crank", metric) == 0);
    }
    CHECK(warnings("heavy_top", "defect.position") == 0);
    CHECK(warnings("free_top", "defect.position") == 1);
}

TEST_CASE("nothing is reported relative to a first integral that is zero", "[campaign]") {
    // A top at rest with its mass centre on the x axis: the vertical angular momentum is zero up to round-off.
    Cell cell = cell_of("heavy_top", "rkmk/rk4", 1, 1000);
    cell.parameters["lever"] = Vector3{0.3, 0, 0};
    cell.parameters["inertia"] = Matrix3{1, 0, 0, 0, 1, 0, 0, 0, 1};
    cell.parameters["omega"] = Vector3{0.7, 0, 0};
    const Outcome outcome = engine_binary64().run(cell, nullptr, {});
    REQUIRE(outcome.status == "ok");
    CHECK(names(outcome).contains("invariant.angular_momentum_vertical"));
    CHECK_FALSE(names(outcome).contains("invariant.angular_momentum_vertical.relative"));
    CHECK(names(outcome).contains("invariant.energy.relative"));
}

TEST_CASE("a body cannot be called ground", "[campaign]") {
    ParameterValues values = defaults("double_pendulum");
    std::get<std::vector<BodyData>>(values["bodies"])[0].name = "ground";
    CHECK_THROWS_AS(engine_binary64().summary("double_pendulum", values, "SE3"), ParameterError);
}

TEST_CASE("a timed cell tells time and memory, counts one run, and keeps no state", "[campaign]") {
    Cell cell = cell_of("chain", "rkmk/rk4", 1e-3, 10);
    cell.formulation = "SO3xR3";
    cell.metrics.clear();
    cell.timed = true;
    const auto measured = [&](double links) {
        cell.parameters["links"] = links;
        return engine_binary64().run(cell, nullptr, {});
    };
    const Outcome few = measured(50), many = measured(400);
    REQUIRE(many.status == "ok");
    CHECK(many.bodies == 400);
    CHECK(many.cost.evaluations == 40);
    CHECK(many.steps_done == 10);
    CHECK_FALSE(many.final.has_value());
    REQUIRE(many.cost.step_s);
    CHECK(*many.cost.step_s > 0);
    CHECK(*many.cost.step_s * 10 <= many.cost.cpu_s);
    CHECK(many.cost.cpu_s >= 0.25 / timing_rounds);
    const auto again = engine_binary64().run_time(cell, {});
    REQUIRE(again);
    CHECK(*again > 0);
    cell.t_end = 1e3;  // each step is too long for its chart
    CHECK_FALSE(engine_binary64().run_time(cell, {}));
    REQUIRE(many.cost.memory);
    CHECK(*many.cost.memory / *few.cost.memory == Approx(8).epsilon(0.1));
}

TEST_CASE("a pattern of a hundred stars matches as fast as any other", "[campaign]") {
    Cell cell = cell_of("heavy_top", "rkmk/rk4", 0.125, 8);
    std::string stars = "*";
    for (int i = 0; i < 100; ++i) stars += "e*";
    cell.metrics = {stars + "final", std::string(100, '*') + "energy.final", stars};
    const Outcome outcome = engine_binary64().run(cell, nullptr, {});
    REQUIRE(outcome.metrics.size() == 1);
    CHECK(outcome.metrics[0].first == "invariant.energy.final");
}

TEST_CASE("past the horizon an error counts where it is above 100 times the reference's uncertainty", "[campaign]") {
    Cell cell = cell_of("heavy_top", "rkmk/rk4", 0.125, 64);
    cell.formulation = "SO3xR3";
    Reference reference = engine_binary128().reference("heavy_top", cell.parameters, 0.125, {});
    const auto errors = [&] {
        std::map<std::string, double> found;
        for (const auto& [name, value] : engine_binary64().run(cell, &reference, {}).metrics)
            if (name.starts_with("error.")) found[name] = value.value;
        return found;
    };
    const auto within = errors();
    REQUIRE(within.size() == 5);
    reference.horizon = 0.1;
    CHECK(errors() == within);  // the routes differ by 1e-28
    const double position = within.at("error.position");
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", position / 99);
    reference.error["error.position"] = {position / 99, text};
    reference.error["error.omega"] = {1e-30, "1e-30"};
    reference.error.erase("error.velocity");
    const auto past = errors();
    CHECK_FALSE(past.contains("error.position"));
    CHECK_FALSE(past.contains("error.velocity"));
    CHECK(past.at("error.omega") == within.at("error.omega"));
    CHECK(past.at("error.rotation") == within.at("error.rotation"));
    reference.state.bodies.clear();
    CHECK(errors().empty());
}

TEST_CASE("an integral that is not finite ends its cell as non_finite", "[campaign]") {
    // A fall whose kinetic energy overflows, and no entry of whose state does.
    const acceptance::Folder folder;
    const std::string config = folder.file("fast.json", R"({"name": "fast", "kind": "drift", "problems": [
        {"name": "multibody", "parameters": {"gravity": [0, 0, -1e90], "joints": [],
         "bodies": [{"name": "body", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [0, 0, 0]}]}}],
        "methods": ["rkmk/rk4"], "metrics": ["invariant.*"], "time": {"end": 1e80, "steps": 10}})");
    const auto said = acceptance::kreisel_with({"run", config, "-o", (folder.path / "out").string()});
    CHECK(said.code == 1);
    CHECK_THAT(said.messages, Catch::Contains("non_finite") && Catch::Contains("invariant.energy"));
}

TEST_CASE("multipliers that are not finite end their cell as non_finite", "[campaign]") {
    const acceptance::Folder folder;
    const std::string config = folder.file("heavy.json", R"({"name": "heavy", "kind": "drift", "metrics": [],
        "problems": [{"name": "asymmetric_heavy_top", "parameters": {"mass": [1e90, 1e60]}}],
        "methods": ["rkmk/rk4"], "time": {"end": 0.01, "steps": 10}})");
    const auto said = acceptance::kreisel_with({"run", config, "-o", (folder.path / "out").string()});
    CHECK(said.code == 1);
    CHECK_THAT(said.messages,
               Catch::Contains("failed: non_finite") && Catch::Contains("multipliers failed at the end"));
    CHECK_THAT(said.messages, Catch::Contains("1 ok, 0 skipped, 1 failed"));
}
