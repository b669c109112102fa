// SPDX-License-Identifier: BSD-3-Clause
//
// What a plan warns of and refuses: errors of the engine, and figures of what the experiment does not hold.
#include <array>
#include <catch2/catch.hpp>

#include "support/errors.hpp"
#include "tests/driver/other_engine.hpp"
#include "tests/driver/plan/planned.hpp"

namespace kreisel::plan_tests {

TEST_CASE("a warning of the engine is said once for all formulations and precisions") {
    const Plan plan = plan_from(one_cell(R"({"name": "heavy_top", "label": "anvil", "parameters": {"mass": 2000}})",
                                         R"(, "formulations": ["SO3xR3", "SE3"], "precision": ["double", "quad"])"));
    CHECK(plan.warnings == std::vector<std::string>{"anvil: a very heavy top"});
}

TEST_CASE("a trajectory without samples gives a warning") {
    const std::string text = R"({"name": "n", "kind": "trajectory", "problems": ["heavy_top"], "methods": ["rkmk/rk4"],
        "time": {"end": 2, "steps": 4})";
    const Plan plan = plan_from(text + "}");
    REQUIRE(plan.warnings.size() == 1);
    CHECK(plan.warnings.front() == "a trajectory without \"output\": {\"samples\": ...} keeps its final state only");
    CHECK(plan_from(text + R"(, "output": {"samples": 2}})").warnings.empty());
}

TEST_CASE("an error of the engine for a cell is reported at its problem or option, once") {
    class Choosy final : public OtherEngine {
      public:
        std::string skip_reason(const Cell& cell) const override {
            if (cell.problem == "free_top") { throw ParameterError("/mass", "expected a top that is lighter"); }
            if (cell.projection == "terze") { throw OptionError("weight", "expected another weight here"); }
            return OtherEngine::skip_reason(cell);
        }
    } const choosy;
    const Engines engines{choosy, choosy};
    const auto refusal = [&](const std::string& problem, const std::string& rest) {
        try {
            plan_of(parse_document("test.json", one_cell(problem, rest)), engines);
        } catch (const UsageError& error) { return std::string(error.what()); }
        return std::string();
    };
    CHECK(refusal("\"heavy_top\"", "") == "");
    const std::string formulations = R"(, "formulations": ["SO3xR3", "SE3"])";
    const std::string mass = refusal(R"({"name": "free_top", "parameters": {"mass": 3}})", formulations);
    CHECK_THAT(mass, Catch::EndsWith(": /problems/0/parameters/mass: expected a top that is lighter"));
    CHECK(mass.find('\n') == std::string::npos);
    CHECK_THAT(refusal("\"heavy_top\"", R"(, "projections": [{"name": "terze", "weight": "mass"}])"),
               Catch::EndsWith(": /projections/0/weight: expected another weight here"));
}

TEST_CASE("a figure may name the curves that its cells can have, and no others") {
    const auto refusal = [](const std::string& keys) {
        try {
            plan_from(R"({"name": "n", "kind": "convergence",
                "problems": [{"name": "heavy_top", "label": "fast, heavy"}, "free_top"],
                "methods": ["rkmk/rk4", {"name": "rkmk/midpoint", "coordinates": ["exp", "cayley"]}],
                "projections": ["none", "terze"], "time": {"end": 1, "steps": [4, 8]},
                "figure": {"kind": "convergence", )" +
                      keys + "}}");
        } catch (const UsageError& error) { return std::string(error.what()); }
        return std::string();
    };
    CHECK(refusal(R"("order": ["rkmk/midpoint cayley", "no projection", "fast, heavy, rkmk/rk4, terze",
                               "free_top, rkmk/midpoint exp, h = 0.25 s"])") == "");
    CHECK(refusal(R"("overlay": {"label": "by hand", "points": [[1, 2]]}, "legend": {"by hand": "ours"})") == "");
    CHECK_THAT(refusal(R"("order": ["rkmk/rk4", "rkmk/rk5"])"), Catch::Contains(": /figure/order/1: expected a name"));
    CHECK_THAT(refusal(R"("legend": {"free_top, rkmk/rk4, tereze": "ours"})"),
               Catch::Contains(": /figure/legend/free_top, rkmk~1rk4, tereze: expected a name that a curve") &&
                   Catch::Contains("did you mean \"free_top, rkmk/rk4, terze\"?"));
    CHECK_THAT(refusal(R"("select": {"problem": "free_top"}, "order": ["fast, heavy"])"),
               Catch::Contains("got \"fast, heavy\""));
    const std::string facet = R"("facet": "problem", "legend": )";
    CHECK(refusal(facet + R"({"rkmk/rk4, terze": "ours"})") == "");
    CHECK_THAT(refusal(facet + R"({"free_top, rkmk/rk4, terze": "ours"})"),
               Catch::Contains("got \"free_top, rkmk/rk4, terze\""));
    for (const char* name : {"", "rkmk/rk4 banana", "rkmk/midpoint coordinates=exp", "rkmk/rk4, rkmk/rk4",
                             "terze, rkmk/rk4", "rkmk/rk4, ", "none"}) {
        CAPTURE(name);
        CHECK_THAT(refusal("\"legend\": {\"" + std::string(name) + "\": \"ours\"}"),
                   Catch::Contains("expected a name that a curve of this experiment can have in a legend"));
    }
}

TEST_CASE("the two axes of a figure differ, and a metric is drawn once") {
    const auto refusal = [](const std::string& figure) {
        try {
            plan_from(one_cell(R"("heavy_top")", R"(, "output": {"samples": 1}, "figure": )" + figure));
        } catch (const UsageError& error) { return std::string(error.what()); }
        return std::string();
    };
    const std::string map = R"({"kind": "heat_map", "metric": "defect.position", )";
    CHECK(refusal(map + R"("x": "steps"})") == "");
    CHECK_THAT(refusal(map + R"("x": "steps", "y": "steps"})"),
               Catch::Contains("/figure/y: expected another axis than that of x, got \"steps\" again"));
    CHECK_THAT(refusal(map + R"("x": "method"})"), Catch::Contains("/figure: expected another axis than that of x"));
    CHECK_THAT(refusal(R"({"kind": "phase_portrait", "x": "v1", "y": "v1"})"), Catch::Contains("\"v1\" again"));
    CHECK_THAT(refusal(R"({"kind": "heat_map", "metric": ["defect.position", "defect.position"]})"),
               Catch::Contains("/figure/metric/1: expected each metric once"));
}

TEST_CASE("a figure may select what the experiment crosses, and nothing else") {
    const auto refusal = [](const std::string& select) {
        try {
            plan_from(R"({"name": "n", "kind": "convergence", "precision": ["double", "quad"],
                "problems": [{"name": "heavy_top", "label": "top"}], "formulations": ["SO3xR3", "SE3"],
                "methods": ["rkmk/rk4", "rkmk/midpoint"], "projections": ["none", "terze"],
                "time": {"end": 1, "steps": [4, 8]}, "figure": {"kind": "convergence", "select": )" +
                      select + "}}");
        } catch (const UsageError& error) { return std::string(error.what()); }
        return std::string();
    };
    CHECK(refusal(R"({"problem": ["top", "heavy_top"], "formulation": "SE3", "method": "rkmk/rk4", "steps": 8,
                      "projection": ["terze", "none"], "precision": "quad"})") == "");
    CHECK(refusal(R"({"method": "rkmk/rk4 dexpinv=0", "projection": "terze weight=mass"})") == "");
    const std::vector<std::array<std::string, 3>> cases = {
        {"problem", "\"free_top\"", "a problem of this experiment, got \"free_top\""},
        {"method", "\"rkmk/rk5\"", "a method of this experiment, got \"rkmk/rk5\"; did you mean \"rkmk/rk4\"?"},
        {"projection", "\"position_velocity\"", "a projection of this experiment, got \"position_velocity\""},
        {"precision", "\"duoble\"", "a precision (\"double\", \"quad\"), got \"duoble\"; did you mean \"double\"?"}};
    for (const auto& [key, value, message] : cases) {
        const std::string text = refusal("{\"" + key + "\": " + value + "}");
        CHECK_THAT(text, Catch::Contains(": /figure/select/" + key + ": expected " + message));
    }
}

}  // namespace kreisel::plan_tests
