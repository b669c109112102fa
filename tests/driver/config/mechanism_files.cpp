// SPDX-License-Identifier: BSD-3-Clause
//
// Parameters of problems from files of their own: what a config makes of them, and where messages point.
#include <catch2/catch.hpp>
#include <filesystem>

#include "driver/config/composition/composed.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/config/bad_mechanisms.hpp"

namespace parameters_from_files {

using namespace kreisel;
using Catch::Contains;
using nlohmann::json;

namespace {

json config_of(const json& parameters) {
    json config = json::parse(good_config());
    config["problems"] = {{{"name", "multibody"}, {"parameters", parameters}}};
    return config;
}

const char* arm = R"(<robot name="arm"><link name="base"/>
<link name="rod"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="hinge" type="revolute"><parent link="base"/><child link="rod"/><limit upper="1"/></joint></robot>)";

}  // namespace

TEST_CASE("parameters from a file are those that it holds, changed by those beside it") {
    ScratchFolder scratch;
    scratch.file("crank.json", good_mechanism());
    json expected = json::parse(good_mechanism());
    expected["project_initial"] = true;
    const std::string file =
        scratch.file("good.json", config_of({{"file", "crank.json"}, {"project_initial", true}}).dump(2));
    CHECK(composed_config(file).value == config_of(expected));
    const ProgramResult from_file = run_program({"plan", file, "--json"});
    const ProgramResult written =
        run_program({"plan", scratch.file("other.json", config_of(expected).dump(2)), "--json"});
    INFO(from_file.messages);
    REQUIRE(from_file.code == 0);
    CHECK(json::parse(from_file.out).at("cells") == json::parse(written.out).at("cells"));
}

TEST_CASE("the path of a mechanism is relative to the config that names it") {
    ScratchFolder scratch;
    std::filesystem::create_directories((scratch / "models").string());
    scratch.file("models/crank.json", good_mechanism());
    scratch.file("models/base.json", config_of({{"file", "crank.json"}}).dump(2));
    const std::string file = scratch.file("last.json", R"({"extends": "models/base.json", "name": "last"})");
    CHECK(composed_config(file).value.at("problems") == config_of(json::parse(good_mechanism())).at("problems"));
    const Document set = composed_config(scratch.file("empty.json", config_of(json::object()).dump(2)),
                                         {"/problems/0/parameters/file=models/crank.json"});
    CHECK(set.value.at("problems") == config_of(json::parse(good_mechanism())).at("problems"));
}

TEST_CASE("messages about a mechanism from a file point into it, those about what changes it into the config") {
    ScratchFolder scratch;
    json mechanism = json::parse(good_mechanism());
    mechanism["bodies"][0]["mas"] = 1;
    scratch.file("bad.json", mechanism.dump(2));
    const auto refusal = [&](const json& parameters) {
        const ProgramResult result = run_program({"check", scratch.file("config.json", config_of(parameters).dump(2))});
        CHECK(result.code == 2);
        return result.messages;
    };
    CHECK_THAT(refusal({{"file", "bad.json"}}),
               Contains("/bad.json:") && Contains(": /problems/0/parameters/bodies/0"));
    scratch.file("good.json", good_mechanism());
    CHECK_THAT(refusal({{"file", "good.json"}, {"project_initial", "down"}}),
               Contains("config.json:") && Contains("/problems/0/parameters/project_initial: expected"));
    CHECK_THAT(refusal({{"file", "none.json"}}), Contains("got \"none.json\", which is no file"));
    CHECK_THAT(refusal({{"file", 3}}), Contains("expected the path of a mechanism"));
    CHECK_THAT(refusal({{"file", "good.json"}, {"positions", {{"hinge", 1}}}}), Contains("/parameters/positions"));
    scratch.file("list.json", "[1]");
    CHECK_THAT(refusal({{"file", "list.json"}}), Contains("expected an object of parameters"));
}

TEST_CASE("a robot is planned as the mechanism it is, with what was left out as warnings") {
    ScratchFolder scratch;
    scratch.file("arm.urdf", arm);
    const auto run = [&](const json& parameters) {
        return run_program({"check", scratch.file("config.json", config_of(parameters).dump(2))});
    };
    const ProgramResult good = run({{"file", "arm.urdf"}, {"positions", {{"hinge", 0.5}}}});
    CHECK(good.code == 0);
    CHECK_THAT(good.messages, Contains("arm.urdf: joints move past their <limit>"));
    CHECK_THAT(run({{"file", "arm.urdf"}, {"positions", {{"hing", 0.5}}}}).messages,
               Contains("did you mean \"hinge\"?"));
    CHECK_THAT(run({{"file", "arm.urdf"}, {"rates", {{"hinge", "fast"}}}}).messages,
               Contains("/problems/0/parameters/rates/hinge: expected a number, got \"fast\""));
    CHECK_THAT(run({{"file", "arm.urdf"}, {"root", "grond"}}).messages, Contains("did you mean \"ground\"?"));
}

}  // namespace parameters_from_files
