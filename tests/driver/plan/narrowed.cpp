// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of configs of which --filter left a part.
#include <catch2/catch.hpp>

#include "driver/config/composition/filter.hpp"
#include "driver/config/resolved.hpp"
#include "support/errors.hpp"
#include "tests/driver/other_engine.hpp"
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

/// Of which the heavy top alone has a momentum, and the free body no constraints.
class TopsOwnMomentum final : public OtherEngine {
  public:
    SystemSummary summary(const std::string& problem, const ParameterValues& values,
                          const std::string& formulation) const override {
        SystemSummary summary = OtherEngine::summary(problem, values, formulation);
        if (problem == "heavy_top") { summary.integrals.push_back({"momentum", "N m s", "about the vertical"}); }
        if (problem == "free_top") {
            summary.constraints = {};
            summary.integrals.clear();
        }
        return summary;
    }
};

const TopsOwnMomentum tops_own_momentum;
const Engines with_momentum{tops_own_momentum, tops_own_momentum};

Plan measuring(const std::string& metrics, const std::vector<std::string>& filters) {
    const Document document = parse_document("test.json", R"({"name": "n", "kind": "drift",
        "problems": ["heavy_top", "free_top"], "methods": ["rkmk/rk4"], "time": {"end": 1, "steps": [4]},
        "metrics": )" + metrics + "}");
    Config config = read_config(document, Catalogue(with_momentum.binary64));
    if (!filters.empty()) { apply_filters(filters, config); }
    return make_plan(document, config, with_momentum);
}

TEST_CASE("a metric of problems that a filter takes away is left out with a warning; one that none has is refused") {
    const std::string both = R"(["invariant.momentum", "defect.orthogonality"])";
    CHECK(measuring(both, {}).config.metrics.size() == 2);
    CHECK(measuring(both, {"problems=heavy_top"}).warnings.empty());
    const Plan plan = measuring(both, {"problems=free_top"});
    CHECK(plan.config.metrics == std::vector<std::string>{"defect.orthogonality"});
    CHECK(plan.warnings == std::vector<std::string>{"/metrics/0: \"invariant.momentum\" is left out: --filter took "
                                                    "the problems that have it away"});
    CHECK(plan_of(parse_document("manifest.json", resolved_config(plan.config)), with_momentum).cells.size() == 1);
    for (const auto& filters : {std::vector<std::string>{}, {"problems=free_top"}}) {
        CHECK_THROWS_WITH(measuring(R"(["invariant.momentun"])", filters),
                          Catch::Contains("/metrics/0: expected a metric of these problems"));
    }
}

TEST_CASE("of a pattern that fits nothing to measure no such pattern is suggested") {
    const auto warning = [](const std::string& pattern) {
        const Plan plan = measuring("[\"" + pattern + "\"]", {"problems=free_top"});
        REQUIRE(plan.warnings.size() == 1);
        return plan.warnings.front();
    };
    CHECK(warning("invariant.*") ==
          "/metrics/0: \"invariant.*\" fits no metric that a cell of this config can measure");
    CHECK(warning("invarian.*") == "/metrics/0: \"invarian.*\" fits no metric that a cell of this config can measure");
    CHECK_THAT(warning("defekt.*"), Catch::EndsWith("; did you mean \"defect.*\"?"));
}

}  // namespace kreisel::narrowed_tests
