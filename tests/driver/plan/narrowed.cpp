// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of configs of which --filter left a part.
#include <catch2/catch.hpp>

#include "driver/config/composition/filter.hpp"
#include "driver/config/resolved.hpp"
#include "support/errors.hpp"
#include "tests/driver/plan/planned.hpp"

namespace kreisel::narrowed_tests {

using nlohmann::json;

/// A config of 2 problems, 2 formulations and 3 methods with these figures.
Document with_figures(const std::string& figures) {
    return parse_document("test.json", R"({"name": "n", "kind": "convergence",
        "problems": [{"name": "heavy_top", "label": "top"}, "free_top"], "formulations": ["SO3xR3", "SE3"],
        "methods": ["rkmk/rk4", "rkmk/midpoint", "baseline/rk4_quaternion"], "time": {"end": 1, "steps": [4, 8]},
        "metrics": ["error.*"], "figure": )" +
                                           figures + "}");
}

Plan filtered(const std::string& figures, const std::vector<std::string>& filters) {
    const Document document = with_figures(figures);
    Config config = read_config(document, Catalogue(one_engine.binary64));
    apply_filters(filters, config);
    return make_plan(document, config, one_engine);
}

std::string refusal(const std::string& figures, const std::vector<std::string>& filters) {
    try {
        filtered(figures, filters);
    } catch (const UsageError& error) { return error.what(); }
    return "";
}

/// What the manifest of the run asks for, which must be a config itself.
json figures_kept(const Plan& plan) {
    const Document document = parse_document("manifest.json", resolved_config(plan.config));
    CHECK(plan_of(document, one_engine).cells.size() == plan.cells.size());
    return document.value.value("figure", json());
}

TEST_CASE("a figure draws what a filter leaves, and a warning says what is missing") {
    const Plan plan = filtered(R"([
        {"kind": "convergence", "name": "both", "select": {"method": ["rkmk/rk4", "rkmk/midpoint"]},
         "legend": {"rkmk/rk4": "ours", "rkmk/midpoint": "theirs"}, "order": ["rkmk/rk4", "rkmk/midpoint", "top"]},
        {"kind": "convergence", "name": "gone", "select": {"method": "rkmk/rk4"}},
        {"kind": "convergence", "name": "whole", "select": {"formulation": "SE3"}}])",
                               {"methods=*/midpoint"});
    CHECK(plan.warnings ==
          std::vector<std::string>{"figure \"both\" is without the method \"rkmk/rk4\", the curve \"rkmk/rk4\", which "
                                   "--filter took away",
                                   "figure \"gone\" is left out: --filter took the method \"rkmk/rk4\" away"});
    CHECK(figures_kept(plan) == json::parse(R"([
        {"kind": "convergence", "name": "both", "select": {"method": ["rkmk/midpoint"]},
         "legend": {"rkmk/midpoint": "theirs"}, "order": ["rkmk/midpoint", "top"]},
        {"kind": "convergence", "name": "whole", "select": {"formulation": "SE3"}}])"));
}

TEST_CASE("without a filter figures stay as they are written") {
    const std::string figure = R"({"kind": "convergence", "select": {"method": "rkmk/rk4"}})";
    CHECK(figures_kept(filtered(figure, {})) == json::parse(figure));
}

TEST_CASE("a figure of which a filter leaves no cell is left out") {
    const Plan plan = filtered(R"({"kind": "convergence", "select": {"formulation": "SE3",
                                   "method": ["rkmk/rk4", "baseline/rk4_quaternion"]}})",
                               {"methods=baseline/*"});
    CHECK(figures_kept(plan) == json::array());
    REQUIRE(plan.warnings.size() == 1);
    CHECK_THAT(plan.warnings.front(),
               Catch::StartsWith("figure \"n\" is left out: of what --filter leaves it can show nothing"));
}

TEST_CASE("what a config never had is refused with a filter too") {
    const std::string select = R"({"kind": "convergence", "select": )";
    const std::vector<std::string> fewer = {"methods=*/midpoint"};
    CHECK(refusal(select + R"({"method": "rkmk/rk4"}})", fewer) == "");
    CHECK_THAT(refusal(select + R"({"method": "rkmk/rk5"}})", fewer),
               Catch::Contains("/figure/select/method: expected a method of this experiment, got \"rkmk/rk5\"; did you "
                               "mean \"rkmk/rk4\"?"));
    CHECK_THAT(refusal(select + R"({"problem": ["top", "tip"]}})", {"problems=free_top"}),
               Catch::Contains("/figure/select/problem/1: expected a problem of this experiment, got \"tip\""));
    CHECK_THAT(refusal(R"({"kind": "convergence", "metric": "error.postion"})", fewer),
               Catch::Contains("did you mean \"error.position\"?"));
}

}  // namespace kreisel::narrowed_tests
