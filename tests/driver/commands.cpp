// SPDX-License-Identifier: BSD-3-Clause
//
// The command line: exit codes, help, the output of list, info and plan.
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "driver/campaign/progress.hpp"
#include "driver/cli/cli.hpp"
#include "driver/plan/estimate/amounts.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/other_engine.hpp"

using namespace kreisel;

namespace {

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("wrong usage ends with 2 and the nearest command or option") {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{}, "A subcommand is required"},
        {{"rnu"}, "did you mean \"run\"?"},
        {{"pln", "x.json"}, "did you mean \"plan\"?"},
        {{"quantum"}, ""},
        {{"run"}, "config is required"},
        {{"run", "x.json", "--resum"}, "did you mean \"--resume\"?"},
        {{"plan", "x.json", "--jsno"}, "did you mean \"--json\"?"},
        {{"run", "x.json", "-j", "0"}, "0"},
        {{"run", "x.json", "-j", "many"}, "many"},
        {{"run", "x.json", "--shard", "4/3"}, "1 <= I <= N"},
        {{"run", "x.json", "--shard", "-1/3"}, "1 <= I <= N"},
        {{"run", "x.json", "--shard", "1of3"}, "1 <= I <= N"},
        {{"list", "metods"}, "did you mean \"methods\"?"},
        {{"info", "heavytop"}, "did you mean \"heavy_top\"?"},
        {{"info", "rk4"}, "did you mean \"rkmk/rk4\"?"},
        {{"quantum"}, "expected a command (\"list\""},
        {{"info", "defect.postion"}, "did you mean \"defect.position\"?"},
    };
    for (const auto& [words, phrase] : cases) {
        const auto result = run_program(words);
        INFO((words.empty() ? "" : words[0]) << ": " << result.messages);
        CHECK(result.code == 2);
        CHECK(result.out.empty());
        CHECK(tells(result.messages, phrase));
    }
    CHECK_FALSE(tells(run_program({"quantum"}).messages, "did you mean"));
}

TEST_CASE("a file or folder that is not there ends with 3") {
    for (const char* command : {"check", "plan", "run", "table", "plot", "merge", "verify"}) {
        const auto result = run_program({command, "/absent"});
        INFO(command << ": " << result.messages);
        CHECK(result.code == 3);
        CHECK(tells(result.messages, "/absent"));
    }
}

TEST_CASE("a metric is described by its name") {
    CHECK(tells(run_program({"info", "defect.position"}).out, "largest |Phi| over all steps"));
    CHECK(tells(run_program({"info", "defect.position.final"}).out, "at the end"));
    CHECK(tells(run_program({"info", "error.position.max"}).out, "the largest over the samples"));
    CHECK(run_program({"info", "error.position.final"}).code == 2);
    CHECK(run_program({"info", "defect.position.max"}).code == 2);
}

TEST_CASE("help and version end with 0") {
    CHECK(tells(run_program({"--help"}).out, "130 interrupted"));
    CHECK(tells(run_program({"run", "--help"}).out, "--resume"));
    CHECK(run_program({"--help"}).code == 0);
    const auto version = run_program({"--version"});
    CHECK(version.code == 0);
    CHECK(tells(version.out, "kreisel "));
}

TEST_CASE("durations and progress in a log") {
    CHECK(duration_text(0.44) == "0.4 s");
    CHECK(duration_text(12) == "12 s");
    CHECK(duration_text(187) == "3 min 07 s");
    CHECK(duration_text(3720) == "1 h 02 min");
    CHECK(duration_text(3.156e10) == "1.0e+03 years");
    CHECK(duration_text(1e99) == "3.2e+91 years");
    ::setenv("TERM", "xterm", 1);
    std::ostringstream out;
    Progress progress(out, "name", true);
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    progress.show({3, 10, 1, 0, 2, 0.2996, 187});
    progress.clear();
    CHECK(tells(out.str(), "name: 29.9 %, 3/10 cells, 0/2 reference solutions, 1 failed, about 3 min 07 s left"));
    CHECK(out.str().ends_with("\r\x1b[K"));
}

TEST_CASE("progress fits the terminal, and is not shown on one that cannot rewrite its line") {
    CHECK(cut_to_terminal("name: 3/10 cells", 12) == "name: 3/10 ");
    CHECK(cut_to_terminal("name: 3/10 cells", 17) == "name: 3/10 cells");
    CHECK(cut_to_terminal("name: 3/10 cells", 0) == "name: 3/10 cells");
    for (const char* kind : {"dumb", "", "xterm"}) {
        ::setenv("TERM", kind, 1);
        std::ostringstream out;
        Progress progress(out, "name", true);
        std::this_thread::sleep_for(std::chrono::milliseconds(250));
        progress.show({3, 10, 1, 0, 2, 0.25, 3});
        progress.clear();
        CHECK(out.str().empty() == (std::string(kind) != "xterm"));
    }
}

TEST_CASE("a log gets whole lines, and not too often") {
    std::ostringstream out;
    Progress progress(out, "name", false);
    progress.show({3, 10, 0, 0, 0, 0.25, 3});
    progress.clear();
    CHECK(out.str().empty());
}

TEST_CASE("list tells all, or one topic") {
    const auto all = run_program({"list"}).out;
    for (const char* name : {"heavy_top", "rkmk/rk4", "position_velocity", "SE3", "error.rotation"}) {
        CHECK(tells(all, name));
    }
    const auto methods = run_program({"list", "methods"}).out;
    CHECK(tells(methods, "order 4; classical"));
    CHECK_FALSE(tells(methods, "heavy_top"));
}

TEST_CASE("info tells parameters, options, integrals and why a formulation is impossible") {
    const auto problem = run_program({"info", "double_pendulum"}).out;
    CHECK(tells(problem, "invariant.energy [J]: forces have a potential"));
    CHECK(tells(problem, "SO3: not possible: no body rotates"));
    const auto top = run_program({"info", "heavy_top"}).out;
    CHECK(tells(top, "mass [kg]: a number greater than 0 (default 15)"));
    CHECK(tells(top, "source2000"));
    const auto mechanism = run_program({"info", "multibody"}).out;
    CHECK(tells(mechanism, "An entry of \"joints\" has a \"type\", and its keys"));
    CHECK(tells(mechanism, "An entry of \"bodies\" has a \"type\", by default \"rigid\""));
    CHECK(tells(mechanism, "revolute     between, point|points, axis|axes, [turn], [name]; turns about the axis"));
    CHECK(tells(mechanism, "rigid  name, mass, inertia, x, [R|quaternion], [v], [omega], [shape]; rigid body"));
    CHECK(tells(mechanism, "stiffness            N/m, of a torsion spring N m/rad"));
    CHECK(tells(mechanism, "the bodies: a list of bodies, at least one (required)"));
    CHECK(tells(mechanism, "the joints: a list of joints (default [])"));
    CHECK(tells(mechanism, "Demonstration (experiments/mechanisms/one_rod.json)\n  bodies  [{\"name\""));
    const auto method = run_program({"info", "rkmk/rk4"}).out;
    CHECK(tells(method, "a whole number from 0 to 20"));
    CHECK(tells(run_program({"info", "fake/relaxed"}).out, "order 2 (configuration), 2 (velocity), 1 (multipliers)"));
    CHECK(tells(run_program({"info", "terze"}).out, "weight"));
    CHECK(tells(run_program({"info", "SE3"}).out, "semidirect"));
}

TEST_CASE("info tells all that has the name of a kind, and the keys of figures") {
    const auto scaling = run_program({"info", "scaling"}).out;
    CHECK(tells(scaling, "scaling, a kind of experiments: "));
    CHECK(tells(scaling, "cells are timed, run one at a time"));
    CHECK(tells(scaling, "scaling, a kind of figures: "));
    CHECK(tells(scaling, "\"cost.step_per_body\""));
    CHECK(tells(scaling, "scaling, a table: "));
    const auto motion = run_program({"info", "motion"}).out;
    CHECK(tells(motion, "how many pictures, evenly spaced over time: a whole number from 1 to 100 (default 9)"));
    CHECK(tells(motion, "[elevation, azimuth] (default [65.0,35.0])"));
    CHECK(tells(run_program({"info", "drift"}).out, "Metrics: \"defect.*\", \"invariant.*\" by default\n"));
    CHECK(tells(run_program({"info", "motoin"}).messages, "did you mean \"motion\"?"));
}

TEST_CASE("plan lists the cells, as text and as JSON") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    const auto table = run_program({"plan", config});
    CHECK(table.code == 0);
    CHECK(tells(table.out, "12 cells: 12 to run, 0 skipped; 1 reference solution; about "));
    CHECK(tells(table.out, "coordinates=cayley dexpinv=exact"));
    const auto json = nlohmann::json::parse(run_program({"plan", config, "--json"}).out);
    REQUIRE(json["cells"].size() == 12);
    CHECK(json["cells"][5]["method"] == "rkmk/rk4");
    CHECK(json["cells"][5].contains("reference"));
}

TEST_CASE("each topic is listed for itself") {
    const std::vector<std::pair<std::string, std::string>> topics = {{"problems", "heavy_top"},
                                                                     {"methods", "rkmk/rk4"},
                                                                     {"projections", "position_velocity"},
                                                                     {"formulations", "SO3xR3"},
                                                                     {"metrics", "invariant.<integral>.slope_error"},
                                                                     {"kinds", "trajectory"},
                                                                     {"figures", "motion"},
                                                                     {"tables", "scaling_laws"},
                                                                     {"configs", "orders_heavy_top"}};
    for (const auto& [topic, entry] : topics) {
        const auto result = run_program({"list", topic});
        INFO(result.out);
        CHECK(result.code == 0);
        CHECK(tells(result.out, entry));
        for (const auto& [other, foreign] : topics) { CHECK((other == topic || !tells(result.out, "  " + foreign))); }
    }
}

TEST_CASE("methods are listed by family and by the properties that they declare") {
    const auto symmetric = run_program({"list", "methods", "--symmetric"});
    CHECK(symmetric.code == 0);
    CHECK(tells(symmetric.out, "rkmk/midpoint"));
    CHECK(tells(symmetric.out, "symmetric (potential systems)"));
    CHECK_FALSE(tells(symmetric.out, "rkmk/rk4"));
    CHECK(tells(run_program({"list", "methods", "--family", "rkmk"}).out, "rkmk/rk4"));
    CHECK_FALSE(tells(run_program({"list", "methods", "--symmetric", "--symplectic"}).out, "rkmk/"));
    const auto unknown = run_program({"list", "methods", "--family", "rkmc"});
    CHECK(unknown.code == 2);
    CHECK(tells(unknown.messages, "did you mean \"rkmk\"?"));
    CHECK(run_program({"list", "problems", "--symplectic"}).code == 2);
}

TEST_CASE("info tells the unit of a first integral's metric and which problem has it") {
    const auto result = run_program({"info", "invariant.energy.slope"});
    CHECK(result.code == 0);
    CHECK(tells(result.out, "invariant.energy.slope: secular rate"));
    CHECK(tells(result.out, "[as the integral per s; the integral in J]\n"));
    CHECK(tells(result.out, "A first integral of double_pendulum: forces have a potential\n"));
    CHECK(run_program({"info", "invariant.spin"}).code == 2);
    CHECK(tells(run_program({"info", "fake/nan"}).out, "Options: none\n"));
}

TEST_CASE("the schema is JSON for a checker") {
    const auto result = run_program({"schema"});
    CHECK(result.code == 0);
    const auto schema = nlohmann::json::parse(result.out);
    CHECK(schema["$schema"] == "http://json-schema.org/draft-07/schema#");
    CHECK(schema["anyOf"][0]["properties"].contains("problems"));
}

TEST_CASE("check tells of each good config how much it computes, and all errors of the bad ones") {
    const ScratchFolder scratch;
    const std::string good = scratch.file("good.json", good_config()), bad = scratch.file("bad.json", "{}"),
                      worse = scratch.file("worse.json", "[");
    const auto result = run_program({"check", good});
    CHECK(result.code == 0);
    CHECK(tells(result.out, good + ": good; 12 cells: 12 to run, 0 skipped; 1 reference solution; about "));
    const auto refused = run_program({"check", good, bad, worse});
    CHECK(refused.code == 2);
    CHECK(refused.out.empty());
    CHECK(tells(refused.messages, "bad.json:1:1: /"));
    CHECK(tells(refused.messages, "\n" + worse + ":1:"));
}

TEST_CASE("an engine that breaks is an internal error, and a disk that does is not") {
    class Broken final : public OtherEngine {
      public:
        std::vector<ProblemDescription> problems() const override { throw std::runtime_error("this engine is broken"); }
        std::vector<MethodDescription> methods() const override {
            throw std::filesystem::filesystem_error("cannot look", std::make_error_code(std::errc::io_error));
        }
    };
    const auto internal = run_program({"list", "problems"}, Broken());
    CHECK(internal.code == 4);
    CHECK(internal.messages == "internal error: this engine is broken\n");
    const auto disk = run_program({"list", "methods"}, Broken());
    CHECK(disk.code == 3);
    CHECK(tells(disk.messages, "cannot look"));
}

TEST_CASE("a standard output that cannot be written is an error") {
    struct Full final : std::streambuf {
        int overflow(int) override { return traits_type::eof(); }
        int sync() override { return -1; }
    } full;
    std::ostringstream messages;
    std::streambuf* const out = std::cout.rdbuf(&full);
    std::streambuf* const err = std::cerr.rdbuf(messages.rdbuf());
    const std::array<const char*, 3> words = {"kreisel", "list", "methods"};
    const int code = kreisel_main(3, words.data(), plain_engine, plain_engine);
    std::cout.rdbuf(out), std::cerr.rdbuf(err);
    std::cout.clear();
    CHECK(code == 3);
    CHECK(messages.str() == "standard output: cannot be written\n");
}
