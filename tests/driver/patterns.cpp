// SPDX-License-Identifier: BSD-3-Clause
//
// Patterns of metrics: what they match, and the message for those that match nothing.
#include "support/pattern.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <random>

#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/other_engine.hpp"

using namespace kreisel;

namespace {

Plan plan_of_top(const std::string& rest, const Engines& engines = one_engine) {
    return plan_of(parse_document("test.json", R"({"name": "n", "kind": "drift", "problems": ["heavy_top"],
        "methods": ["rkmk/rk4"], "time": {"end": 2, "steps": 4})" +
                                                   rest + "}"),
                   engines);
}

}  // namespace

TEST_CASE("patterns") {
    CHECK(matches("error.*", "error.position"));
    CHECK(matches("*", ""));
    CHECK(matches("*.fin*l", "defect.position.final"));
    CHECK(matches("a*b*c", "aXbYbZc"));
    CHECK_FALSE(matches("a*b*c", "aXbYbZ"));
    CHECK_FALSE(matches("error.position", "error.positions"));
    CHECK_FALSE(matches("", "x"));
    CHECK_FALSE(matches(std::string(30, '*') + "b", std::string(5000, 'a')));
    std::string hostile = "invariant.";
    for (int i = 0; i < 100; ++i) { hostile += "*"; }
    CHECK(matches(hostile + "final", "invariant.energy.final"));
    CHECK_FALSE(matches(hostile + "final", "invariant.energy.finals"));
    for (int i = 0; i < 100; ++i) { hostile += "a*"; }
    CHECK_FALSE(matches(hostile + "b", std::string("invariant.") + std::string(5000, 'a')));
}

TEST_CASE("patterns match what the definition says, on random texts of two letters") {
    // A pattern that begins with a star matches if its rest matches some suffix of the name.
    const std::function<bool(std::string_view, std::string_view)> defined = [&](std::string_view p,
                                                                                std::string_view n) {
        if (p.empty()) { return n.empty(); }
        if (p[0] != '*') { return !n.empty() && p[0] == n[0] && defined(p.substr(1), n.substr(1)); }
        for (std::size_t i = 0; i <= n.size(); ++i) {
            if (defined(p.substr(1), n.substr(i))) { return true; }
        }
        return false;
    };
    std::mt19937 random(7);
    const auto text = [&](const std::string& letters, std::size_t longest) {
        std::string word(random() % (longest + 1), ' ');
        for (char& c : word) { c = letters[random() % letters.size()]; }
        return word;
    };
    int fitting = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::string pattern = text("ab**", 8), name = text("ab", 9);
        INFO(pattern << " on " << name);
        REQUIRE(matches(pattern, name) == defined(pattern, name));
        fitting += matches(pattern, name) ? 1 : 0;
    }
    CHECK(fitting > 1000);
    CHECK(fitting < 19000);
    CHECK(matches_any(std::vector<std::string>{"x", "a*"}, "ab"));
    CHECK_FALSE(matches_any(std::vector<std::string>{}, "ab"));
}

TEST_CASE("a metric or pattern that no cell can measure is warned of, and a plain name must exist") {
    const auto warnings = [](const std::string& metrics, const std::string& formulations = "\"SO3xR3\"") {
        return plan_of_top(R"(, "metrics": )" + metrics + R"(, "formulations": [)" + formulations + "]").warnings;
    };
    using Texts = std::vector<std::string>;
    CHECK(warnings(R"(["error.*", "defect.*", "invariant.*", "*", "error.position"])").empty());
    CHECK(warnings(R"([])").empty());
    CHECK(
        warnings(R"(["defect.*", "eror.*"])") ==
        Texts{
            "/metrics/1: \"eror.*\" fits no metric that a cell of this config can measure; did you mean \"error.*\"?"});
    CHECK(warnings(R"(["momentum*xyz"])") ==
          Texts{"/metrics/0: \"momentum*xyz\" fits no metric that a cell of this config can measure"});
    CHECK(warnings("[\"" + std::string(99, '*') + "x\"]").empty() == false);
    // The fake engine's SO3 has the constraints of the others; a body without any has none to measure.
    class Free final : public OtherEngine {
      public:
        SystemSummary summary(const std::string& problem, const ParameterValues& values,
                              const std::string& formulation) const override {
            SystemSummary summary = OtherEngine::summary(problem, values, formulation);
            if (formulation == "SO3") {
                summary.constraints = {};
                summary.integrals.clear();
            }
            return summary;
        }
    } const free;
    const auto free_warnings = [&](const std::string& formulations) {
        return plan_of_top(
                   R"(, "metrics": ["defect.position", "invariant.energy", "defect.orthogonality", "error.multipliers"],
            "formulations": [)" +
                       formulations + "]",
                   {free, free})
            .warnings.size();
    };
    CHECK(free_warnings(R"("SO3xR3", "SO3")") == 0);
    // invariant.energy is then not a name at all
    CHECK_THROWS_WITH(free_warnings(R"("SO3")"), Catch::Contains("/metrics/1: expected a metric of these problems"));
}
