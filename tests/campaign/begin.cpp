// SPDX-License-Identifier: BSD-3-Clause
//
// Runs that go on from a sample of an earlier one: the same bits, what is said of drift and memory, and each state that
// is none of the mechanism.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "driver/config/composition/composed.hpp"
#include "driver/config/resolved.hpp"
#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"
#include "support/errors.hpp"
#include "tests/campaign/acceptance.hpp"
#include "tests/campaign/program.hpp"

namespace runs_from_samples {

using namespace kreisel;
using Catch::Contains;
using nlohmann::json;

namespace {

const Engines engines{engine_binary64(), engine_binary128()};

/// A wheel that winds up a spring over several turns, and carries a driven arm on whose end a force pulls that changes.
json winder() {
    return {{"name", "multibody"}, {"label", "winder"}, {"parameters", json::parse(R"({
        "bodies": [{"name": "wheel", "mass": 2, "inertia": [0.1, 0.12, 0.2], "x": [0, 0, 0], "omega": [0, 0, 17]},
                   {"name": "arm", "mass": 1, "inertia": [0.01, 0.05, 0.05], "x": [0.9, 0.1, 0]}],
        "joints": [{"type": "revolute", "between": ["ground", "wheel"], "point": [0, 0, 0], "axis": [0, 0, 1]},
                   {"type": "revolute", "between": ["wheel", "arm"], "point": [0.4, 0, 0], "axis": [0, 1, 0],
                    "turn": {"polynomial": [0, 1], "sinusoids": [{"amplitude": 0.3, "frequency": 5}]}}],
        "forces": [{"type": "torsion_spring", "between": ["ground", "wheel"], "axis": [0, 0, 1], "stiffness": 0.8,
                    "turns": 2},
                   {"type": "force", "body": "arm", "value": [0, 3, 1], "amplitude": 0.5, "frequency": 7}]})")}};
}

json top(const json& formulations = {"SO3xR3"}) {
    return {{"name", "top"},
            {"kind", "trajectory"},
            {"problems", {"heavy_top"}},
            {"formulations", formulations},
            {"methods", {"rkmk/rk4"}},
            {"time", {{"end", 0.02}, {"steps", 20}}},
            {"output", {{"samples", 2}}}};
}

Plan plan_in(const acceptance::Folder& folder, const json& config) {
    return plan_of(composed_config(folder.file("config.json", config.dump())), engines);
}

/// The samples of a cell as the file that a run writes.
std::string sampled(const PlannedCell& planned, const Engine& engine = engine_binary64()) {
    acceptance::Samples samples;
    REQUIRE(engine.run(planned.cell(), nullptr, {}, &samples).status == "ok");
    std::ostringstream text;
    for (std::size_t i = 0; i < samples.columns.size(); ++i)
        text << (i == 0 ? "" : ",") << samples.columns[i].name << " [" << samples.columns[i].unit << "]";
    for (const std::string& row : samples.rows) text << "\n" << row;
    return text.str() + "\n";
}

/// The last line up to the columns that are measured: time, bodies, angles and turns of springs, forces of joints.
std::string last_state(const std::string& samples, std::size_t columns) {
    std::istringstream lines(samples.substr(samples.rfind('\n', samples.size() - 2) + 1));
    std::string state, field;
    for (std::size_t i = 0; i < columns && std::getline(lines, field, ','); ++i) state += field + ",";
    return state;
}

/// What is said of a config that begins at `begin`; empty if nothing is wrong.
std::string refusal(const acceptance::Folder& folder, json config, const json& begin) {
    config["time"]["begin"] = begin;
    try {
        plan_in(folder, config);
    } catch (const std::exception& error) { return error.what(); }
    return "";
}

json config_of_winder(const char* precision, const char* method, const char* projection, long steps, double end) {
    return {{"name", "winder"},
            {"kind", "trajectory"},
            {"precision", precision},
            {"problems", {winder()}},
            {"methods", {method}},
            {"projections", {projection}},
            {"time", {{"end", end}, {"steps", steps}}},
            {"output", {{"samples", 2}}}};
}

}  // namespace

TEST_CASE("explicit one-step methods go on from a sample to the same bits, turns and times among them", "[campaign]") {
    constexpr std::size_t state = 1 + 2 * 18 + 2;  // t, two bodies, theta and turns
    const acceptance::Folder folder;
    struct Case {
        const char *precision, *method, *projection;
        long steps;
    };
    // 0.7 s is a whole number of steps of 1.4 s / 140 up to round-off only.
    for (const Case& one :
         {Case{"double", "rkmk/rk4", "none", 140}, Case{"double", "rkmk/dopri5", "position_velocity", 140},
          Case{"double", "crouch_grossman/cg4a", "none", 256}, Case{"quad", "commutator_free/cf4", "velocity", 140}}) {
        INFO(one.method << " in " << one.precision);
        const Engine& engine = engines.of(one.precision);
        json config = config_of_winder(one.precision, one.method, one.projection, one.steps, 1.4);
        const std::string whole = sampled(plan_in(folder, config).cells.at(0), engine);
        folder.file("whole.csv", whole);
        config["time"] = {{"begin", {{"file", "whole.csv"}, {"t", 0.7}}}, {"end", 1.4}, {"steps", one.steps / 2}};
        const Plan plan = plan_in(folder, config);
        const std::string rest = sampled(plan.cells.at(0), engine);
        CHECK(last_state(rest, state) == last_state(whole, state));
        CHECK(std::abs(plan.config.begin->turns.at("ground-wheel")) > 1);
        CHECK(plan.cells[0].identity().h == Approx(1.4 / static_cast<double>(one.steps)));
        // One that forgets its turns moves otherwise.
        json forgetful = json::parse(resolved_config(plan.config));
        CHECK(plan_in(folder, forgetful).cells.at(0).hash() == plan.cells[0].hash());
        forgetful["time"]["begin"]["turns"]["ground-wheel"] = 0;
        const Plan other = plan_in(folder, forgetful);
        CHECK(other.cells[0].hash() != plan.cells[0].hash());
        CHECK(last_state(sampled(other.cells[0], engine), state) != last_state(whole, state));
    }
}

TEST_CASE("implicit one-step methods go on from a sample up to the round-off of their iterations", "[campaign]") {
    const acceptance::Folder folder;
    json config = config_of_winder("double", "rkmk/implicit_midpoint", "none", 256, 1.4);
    const PlannedCell whole = plan_in(folder, config).cells.at(0);
    folder.file("whole.csv", sampled(whole));
    config["time"] = {{"begin", {{"file", "whole.csv"}, {"t", 0.7}}}, {"end", 1.4}, {"steps", 128}};
    const PlannedCell rest = plan_in(folder, config).cells.at(0);
    const auto end = [](const PlannedCell& planned) {
        return engine_binary64().run(planned.cell(), nullptr, {}).final->bodies.at(1).x;
    };
    const auto once = end(whole), twice = end(rest);
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(once[i].value - twice[i].value) < 1e-11);
}

TEST_CASE("drift of a sample is taken and told, and so is what starts anew", "[campaign]") {
    const acceptance::Folder folder;
    json config = top();
    folder.file("top.csv", sampled(plan_in(folder, config).cells.at(0)));
    config["time"] = {{"begin", {{"file", "top.csv"}}}, {"end", 0.03}, {"steps", 10}};
    config["methods"] = {"rkmk/rk4", "multistep/bliedf2"};
    const Plan plan = plan_in(folder, config);
    CHECK(plan.config.begin->t.text == "0.02");
    std::string warnings;
    for (const std::string& warning : plan.warnings) warnings += warning + "\n";
    CHECK_THAT(warnings, Contains("/time/begin: heavy_top in SO3xR3 misses its joints by "));
    CHECK_THAT(warnings, Contains("/time/begin: multistep/bliedf2 starts anew at t = 0.02 s"));
    CHECK_THAT(warnings, !Contains("rkmk/rk4 starts anew"));
    for (const PlannedCell& planned : plan.cells)
        CHECK(engine_binary64().run(planned.cell(), nullptr, {}).status == "ok");
    CHECK(plan.cells[0].identity().t_begin == 0.02);
}

TEST_CASE("references go on from a state at its time, and so do both routes to them", "[campaign]") {
    const acceptance::Folder folder;
    json config = config_of_winder("double", "rkmk/rk4", "none", 256, 0.4);
    config["metrics"] = {"error.*"};
    const Plan whole = plan_in(folder, config);
    const Cell& cell = whole.cells.at(0).cell();
    const Engine& quad = engine_binary128();
    const ReportedState middle = quad.reference(cell.problem, cell.parameters, 0.2, {}).state;
    BeginState begin{middle.t, middle.bodies, {{"ground-wheel", middle.turns.at(0)}}};
    REQUIRE(std::abs(middle.turns[0]) > 1);
    const Reference once = quad.reference(cell.problem, cell.parameters, 0.4, {});
    const auto apart = [&](const Reference& other) {
        double most = 0;
        for (std::size_t i = 0; i < once.state.bodies.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const Number &a = once.state.bodies[i].omega[k], &b = other.state.bodies[i].omega[k];
                most = std::max(most, std::abs(a.value - b.value));
            }
        return most;
    };
    const Reference twice = quad.reference(cell.problem, cell.parameters, &begin, 0.4, 2, {});
    CHECK(apart(twice) < 1e-13);
    REQUIRE(twice.samples.size() == 2);
    CHECK(twice.samples[0].state.t.value == Approx(0.3));
    CHECK(twice.error.at("error.position").value < 1e-22);
    const ReferenceCheck check = quad.check_reference(cell.problem, cell.parameters, &begin, twice);
    CHECK(check.difference.at("error.position").value < 1e-22);
    CHECK(quad.check_reference(cell.problem, cell.parameters, &begin, once).difference.at("error.position").value <
          1e-22);
    const BeginState early{{0.1, "0.1"}, begin.bodies, begin.turns},
        unwound{begin.t, begin.bodies, {{"ground-wheel", 0}}};
    for (const BeginState* other : {&early, &unwound}) {
        CHECK(apart(quad.reference(cell.problem, cell.parameters, other, 0.4, 0, {})) > 1e-3);
        CHECK(quad.check_reference(cell.problem, cell.parameters, other, once).difference.at("error.position").value >
              1e-3);
    }
}

TEST_CASE("errors of runs from a sample fall at the order of the method", "[campaign]") {
    const acceptance::Folder folder;
    json config = config_of_winder("double", "rkmk/rk4", "none", 2048, 1.4);
    folder.file("whole.csv", sampled(plan_in(folder, config).cells.at(0)));
    config["metrics"] = {"error.position", "error.position.max"};
    config["time"] = {{"begin", {{"file", "whole.csv"}, {"t", 0.7}}}, {"end", 1.4}, {"steps", {128, 256}}};
    const Plan plan = plan_in(folder, config);
    REQUIRE(plan.references.size() == 1);
    const PlannedReference& planned = plan.references.begin()->second;
    REQUIRE(planned.begin);
    json later = config;
    later["time"]["begin"]["t"] = 1.4;
    later["time"]["end"] = 2.1;
    CHECK(plan_in(folder, later).references.begin()->second.content != planned.content);
    const Reference reference = engine_binary128().reference(planned.problem, planned.parameters, planned.begin.get(),
                                                             planned.t_end, planned.samples, {});
    const auto error = [&](std::size_t i, const std::string& metric) {
        for (const auto& [name, value] : engine_binary64().run(plan.cells.at(i).cell(), &reference, {}).metrics)
            if (name == metric) return value.value;
        FAIL("no " << metric);
        return 0.0;
    };
    for (const char* metric : {"error.position", "error.position.max"})
        CHECK(std::log2(error(0, metric) / error(1, metric)) == Approx(4).margin(0.2));
}

TEST_CASE("a state that a run cannot go on from is refused where it stands", "[campaign]") {
    const acceptance::Folder folder;
    const std::string drifted = sampled(plan_in(folder, top()).cells.at(0));
    folder.file("top.csv", drifted);
    const json last = {{"file", "top.csv"}};
    json after = top();
    after["time"] = {{"end", 1}, {"steps", 2}};
    const auto with = [&](const char* key, const json& value) {
        json config = after;
        config[key] = value;
        return config;
    };
    CHECK(refusal(folder, after, last) == "");
    const auto says = [&](const json& config, const json& begin, const std::string& place, const std::string& phrase) {
        const std::string message = refusal(folder, config, begin);
        INFO(begin << "\n" << message);
        CHECK(message.find(place) != std::string::npos);
        CHECK(message.find(phrase) != std::string::npos);
    };
    json state = json::parse(resolved_config([&] {
        json config = after;
        config["time"]["begin"] = last;
        return plan_in(folder, config).config;
    }()))["time"]["begin"];
    const auto state_with = [&](const char* place, const json& value) {
        json other = state;
        other[json::json_pointer(place)] = value;
        return other;
    };
    CHECK(refusal(folder, after, state) == "");
    says(after, {{"file", "tpo.csv"}}, "/time/begin/file: ", "\"tpo.csv\", which is no file");
    says(after, {{"file", 3}}, "/time/begin/file: ", "the path of a trajectory");
    says(after, {{"file", "top.csv"}, {"T", 1}}, "/time/begin/T: ", "\"t\"");
    says(after, {{"file", "top.csv"}, {"t", 0.013}},
         "/time/begin/t: ", "got 0.013, to which that at 0.01 s is nearest");
    says(after, {{"file", "top.csv"}, {"t", "0.01"}}, "/time/begin/t: ", "the time of a sample");
    says(after, {{"file", "top.csv"}, {"t", -1}}, "/time/begin/t: ", "at least 0");
    says(with("time", {{"end", 0.02}, {"steps", 2}}), last,
         "/time/end: ", "an end after the time of \"begin\", 0.02 s");
    says(with("time", {{"end", 1}, {"step", 0.3}}), last, "/time/step: ", "the time from begin to end, 0.98");
    says(with("problems", json::array({winder()})), last,
         "/time/begin: ", "with the bodies \"arm\", \"wheel\", got \"top\"");
    says(with("formulations", {"SO3xR3", "SO3"}), last, "/time/begin: ", "a state that formulation SO3 holds");
    says(after, {{"fiel", "top.csv"}}, "/time/begin/fiel: ", "did you mean \"file\"?");
    CHECK(refusal(folder, after, {{"fiel", "top.csv"}}).find("bodies\": ") == std::string::npos);
    says(after, state_with("/file_", "top.csv"), "/time/begin/file_: ", "did you mean \"file\"?");
    folder.file("results.csv", "cell,problem\n1,top\n");
    says(after, {{"file", "results.csv"}},
         "/time/begin/file: ", "whose first column is \"t [s]\", got one whose first line begins with \"cell\"");
    folder.file("empty.csv", "");
    says(after, {{"file", "empty.csv"}}, "/time/begin/file: ", "got one that begins with an empty line");
    std::filesystem::create_directory(folder.path / "trajectories");
    says(after, {{"file", "results.csv"}}, "/time/begin/file: ", "in the folder \"trajectories\" beside it");
    says(after, 3, "/time/begin: ", "a state");
    says(after, json::object(), "/time/begin: ", "the key \"t\"");
    says(after, state_with("/t", "1,5"), "/time/begin/t: ", "the time of the sample");
    says(after, state_with("/bodies", json::array()), "/time/begin/bodies: ", "the states of all bodies");
    says(after, state_with("/bodies/0/x", {1, 2}), "/time/begin/bodies/0/x: ", "three numbers");
    says(after, state_with("/bodies/0/x/1", "one"), "/time/begin/bodies/0/x/1: ", "a number");
    says(after, state_with("/bodies/0/x/1", "1e999"), "/time/begin/bodies/0/x/1: ", "at most 1e+100");
    says(after, state_with("/bodies/0/R/2", 1), "/time/begin/bodies/0/R/2: ", "three numbers");
    says(after, state_with("/bodies/0/R/2", {9, 9, 9}), "/time/begin: ", "a rotation R of body \"top\"");
    says(after, state_with("/bodies/0/omgea", {1, 2, 3}), "/time/begin/bodies/0/omgea: ", "did you mean \"omega\"?");
    says(after, state_with("/bodies/1", state["bodies"][0]), "/time/begin/bodies/1: ", "a second \"top\"");
    says(after, state_with("/turns", {{"ground-top", 1}}), "/time/begin: ", "the torsion springs none");
    says(after, state_with("/turns", {{"ground-top", 1.5}}),
         "/time/begin/turns/ground-top: ", "a number of full turns");
}

TEST_CASE("damaged samples are told by file and line", "[campaign]") {
    const acceptance::Folder folder;
    const std::string good = sampled(plan_in(folder, top()).cells.at(0));
    const auto says = [&](const std::string& text, const std::string& phrase) {
        folder.file("bad.csv", text);
        const std::string message = refusal(folder, top(), {{"file", "bad.csv"}, {"t", 0.01}});
        INFO(message);
        CHECK(message.find(phrase) != std::string::npos);
    };
    std::string text = good;
    says(text.substr(0, text.size() - 3), "bad.csv:4: damaged: its last line is torn");
    says(text.substr(0, text.find('\n') + 1), "bad.csv:2: damaged: it has no sample");
    says("t [s]\n0.01\n", "bad.csv:1: damaged: expected samples of bodies");
    says("t [s],top.x1 [m]\n0.01,1\n", "bad.csv:1: damaged: it has no column top.x2 [m]");
    says(text.insert(text.find("\n0.01,") + 6, "a"), "bad.csv:3: damaged: top.x1 [m] is no number");
    text = good;
    says(text.insert(text.find("\n0.01,") + 5, ",1"), "bad.csv:3: damaged: wrong number of columns");
    text = good;
    says(text.replace(text.find("\n0.01,") + 1, 4, "nan"), "bad.csv:3: damaged: its time is no number");
}

TEST_CASE("samples in a results folder are held against the sum of their cell", "[campaign]") {
    const acceptance::Folder folder;
    const std::string results = (folder.path / "results").string();
    REQUIRE(acceptance::kreisel_with({"run", folder.file("top.json", top().dump()), "-o", results, "-j", "1"}).code ==
            0);
    std::filesystem::path file;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path / "results/trajectories"))
        file = entry.path();
    const json begin = {{"file", "results/trajectories/" + file.filename().string()}, {"t", 0.01}};
    json config = top();
    CHECK(refusal(folder, config, begin) == "");
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    std::string changed = text.str();
    char& digit = changed[changed.find("\n0.01,") + 10];
    digit = digit == '1' ? '2' : '1';
    std::ofstream(file) << changed;
    CHECK_THAT(refusal(folder, config, begin), Contains("damaged: its sum is not the one of its cell"));
    config["time"]["begin"] = begin;
    const auto said = acceptance::kreisel_with({"check", folder.file("next.json", config.dump())});
    CHECK(said.code == static_cast<int>(Exit::io));
    CHECK_THAT(said.messages, Contains(file.filename().string()));
}

}  // namespace runs_from_samples
