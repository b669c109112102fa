// SPDX-License-Identifier: BSD-3-Clause
//
// From a config to its cells.
#include <array>
#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "driver/config/resolved.hpp"
#include "driver/plan/plan.hpp"
#include "records/json/diagnostics.hpp"
#include "records/json/strict.hpp"
#include "support/errors.hpp"
#include "support/hash.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/other_engine.hpp"

using namespace kreisel;

namespace {

Plan plan_from(const std::string& text) { return plan_of(parse_document("test.json", text), one_engine); }

std::string one_cell(const std::string& problem, const std::string& rest) {
    return R"({"name": "n", "kind": "drift", "problems": [)" + problem +
           R"(], "methods": ["rkmk/rk4"], "time": {"end": 2, "steps": 4})" + rest + "}";
}

std::string hash_of(const std::string& text) {
    const Plan plan = plan_from(text);
    REQUIRE(plan.cells.size() == 1);
    return plan.cells.front().hash();
}

}  // namespace

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

TEST_CASE("an inertia may be written as three numbers or as a matrix") {
    CHECK(hash_of(one_cell(R"({"name": "heavy_top", "parameters": {"inertia": [1, 2, 2]}})", "")) ==
          hash_of(
              one_cell(R"({"name": "heavy_top", "parameters": {"inertia": [[1, 0, 0], [0, 2, 0], [0, 0, 2]]}})", "")));
}

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

TEST_CASE("a warning of the engine is said once for all formulations and precisions") {
    const Plan plan = plan_from(one_cell(R"({"name": "heavy_top", "label": "anvil", "parameters": {"mass": 2000}})",
                                         R"(, "formulations": ["SO3xR3", "SE3"], "precision": ["double", "quad"])"));
    CHECK(plan.warnings == std::vector<std::string>{"anvil: a very heavy top"});
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

TEST_CASE("a long value is cut between characters") {
    std::string text;
    for (int i = 0; i < 20; ++i) { text += "ä"; }
    CHECK(in_quotes("x" + text + text) == "\"x" + text + "äääääääää...\"");
    CHECK(in_quotes(text) == "\"" + text + "\"");
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
