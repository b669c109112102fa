// SPDX-License-Identifier: BSD-3-Clause
//
// Errors as maxima over samples, against the errors at the ends of runs to each sample.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "plots/laws/convergence.hpp"
#include "records/reading/read_results.hpp"
#include "records/results.hpp"
#include "tests/campaign/program.hpp"

using namespace kreisel;
using namespace kreisel::acceptance;

namespace {

Cell sampled_cell(const std::string& method, long steps, long samples) {
    Cell cell{.problem = "forced_heavy_top",
              .parameters = defaults("forced_heavy_top"),
              .formulation = "SO3xR3",
              .method = method,
              .options = {},
              .projection = "none",
              .projection_options = {},
              .t_end = 0.5,
              .steps = steps,
              .samples = samples,
              .metrics = {"error.*"}};
    for (const MethodDescription& description : engine_binary64().methods())
        if (description.name == method) cell.options = standard_options(description);
    return cell;
}

std::map<std::string, double> metrics_of_run(const Cell& cell, const Reference& reference) {
    const Outcome outcome = engine_binary64().run(cell, &reference, {});
    INFO(outcome.detail);
    REQUIRE(outcome.status == "ok");
    std::map<std::string, double> metrics;
    for (const auto& [name, number] : outcome.metrics) metrics[name] = number.value;
    return metrics;
}

Reference reference_of(const Cell& cell, long samples) {
    return engine_binary128().reference(cell.problem, cell.parameters, cell.t_end, samples, {});
}

const Reference& quarters() {
    static const Reference reference = reference_of(sampled_cell("rkmk/rk4", 512, 4), 4);
    return reference;
}

}  // namespace

TEST_CASE("a maximum over samples is the largest of the errors at their times", "[campaign]") {
    for (const char* method : {"rkmk/rk4", "generalized_alpha/index2"}) {
        const Cell whole = sampled_cell(method, 512, 4);
        std::map<std::string, double> largest;
        for (long k = 1; k <= 4; ++k) {
            Cell part = whole;
            part.t_end = 0.125 * static_cast<double>(k), part.steps = 128 * k, part.samples = 0;
            for (const auto& [name, error] : metrics_of_run(part, reference_of(part, 0)))
                largest[name] = std::max(largest[name], error);
        }
        REQUIRE(largest.size() == 5);
        const auto metrics = metrics_of_run(whole, quarters());
        CHECK(metrics.size() == 10);
        for (const auto& [name, error] : largest) {
            INFO(method << " " << name);
            CHECK(metrics.at(name + ".max") == Approx(error).epsilon(1e-6));
            CHECK(metrics.at(name) <= metrics.at(name + ".max") * (1 + 1e-6));
        }
    }
}

TEST_CASE("samples between steps to a tolerance count", "[campaign]") {
    Cell cell = sampled_cell("rkmk/dopri5", 0, 4);
    cell.tolerance = 1e-6;
    Cell shortened = cell;
    shortened.dense = false;
    const auto between = metrics_of_run(cell, quarters()), met = metrics_of_run(shortened, quarters());
    CHECK(between.at("error.position.max") >= between.at("error.position"));
    CHECK(between.at("error.position.max") < 1e-4);
    CHECK(between.at("error.rotation.max") != met.at("error.rotation.max"));  // other states, of similar accuracy
    CHECK(std::abs(std::log10(between.at("error.rotation.max") / met.at("error.rotation.max"))) < 2);
}

TEST_CASE("a maximum over samples that are not all known is absent", "[campaign]") {
    const Cell cell = sampled_cell("rkmk/rk4", 512, 4);
    const auto has = [&](const Cell& one, const Reference& reference) {
        return metrics_of_run(one, reference).contains("error.position.max");
    };
    REQUIRE(has(cell, quarters()));
    Reference fewer = quarters();
    fewer.samples.clear();
    CHECK_FALSE(has(cell, fewer));
    Cell unsampled = cell;
    unsampled.samples = 0;
    CHECK_FALSE(has(unsampled, quarters()));
    Cell unasked = cell;
    unasked.metrics = {"error.position"};
    CHECK_FALSE(has(unasked, quarters()));
    Reference uncertain = quarters();
    uncertain.horizon = 0.25;  // all errors are below 100 times this
    uncertain.error["error.position.max"] = {1, "1"};
    CHECK_FALSE(has(cell, uncertain));
    uncertain.error["error.position.max"] = {1e-20, "1e-20"};
    CHECK(has(cell, uncertain));
}

TEST_CASE("a convergence study has orders of maxima over samples, of multipliers too", "[campaign]") {
    const Folder folder;
    const auto config = folder.file("maxima.json", R"({"name": "maxima", "kind": "convergence",
        "problems": ["forced_heavy_top"], "methods": ["rkmk/rk4"], "metrics": ["error.position*", "error.multipliers*"],
        "time": {"end": 0.5, "steps": {"from": 64, "levels": 5}}, "output": {"samples": 8},
        "figure": {"kind": "convergence", "metric": ["error.position.max", "error.multipliers.max"]}})");
    const std::string out = (folder.path / "out").string();
    REQUIRE(kreisel_with({"run", config, "-o", out}).code == 0);
    REQUIRE(kreisel_with({"table", out}).code == 0);
    const Results results = read_results(out);
    CHECK(error_metrics(results.rows) == std::vector<std::string>{"error.position", "error.position.max",
                                                                  "error.multipliers", "error.multipliers.max"});
    const auto groups = group_by_method(results.rows);
    REQUIRE(groups.size() == 1);
    for (const char* metric : {"error.position.max", "error.multipliers.max"}) {
        const ObservedOrder order = order_of(groups[0], metric);
        INFO(metric << ": " << order.reason);
        REQUIRE(order.order);
        CHECK(std::abs(*order.order - 4) < 0.1);
        CHECK(groups[0].front().declared_order->at(metric) == 4);
    }
    CHECK(kreisel_with({"verify", out, "--cells", "1"}).code == 0);
}
