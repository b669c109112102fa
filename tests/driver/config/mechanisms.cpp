// SPDX-License-Identifier: BSD-3-Clause
//
// Mechanisms in a config: what is refused and where, which values are accepted, and how they are written back.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "driver/config/config.hpp"
#include "records/json/strict.hpp"
#include "records/json/writer.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/config/bad_mechanisms.hpp"

using namespace kreisel;
using nlohmann::ordered_json;

namespace {

std::string config_with(const ordered_json& parameters) {
    ordered_json config = ordered_json::parse(good_config());
    config["problems"] = {{{"name", "multibody"}, {"parameters", parameters}}};
    return config.dump(2);
}

ParameterValues read(const ordered_json& parameters) {
    return read_config(parse_document("good.json", config_with(parameters)), Catalogue{FakeEngine()})
        .problems[0]
        .parameters();
}

template <class Data>
std::vector<Data> entries(const std::string& key, const std::string& list) {
    ordered_json parameters = {
        {"bodies", {ordered_json::parse(R"({"name": "b", "mass": 1, "inertia": [1, 1, 1], "x": [0, 0, 0]})")}}};
    parameters[key] = ordered_json::parse(list);
    return std::get<std::vector<Data>>(read(parameters).at(key));
}

}  // namespace

TEST_CASE("the mechanism that the bad ones are made from is good") {
    const ScratchFolder scratch;
    const std::string text = config_with(ordered_json::parse(good_mechanism()));
    const auto result = run_program({"check", scratch.file("good.json", text)});
    CHECK(result.messages == "");
    CHECK(result.code == 0);
}

TEST_CASE("each bad mechanism is refused at its error") {
    const ScratchFolder scratch;
    REQUIRE(bad_mechanisms().size() >= 60);
    for (const BadMechanism& bad : bad_mechanisms()) {
        ordered_json parameters = ordered_json::parse(good_mechanism());
        parameters[ordered_json::json_pointer(bad.place)] = ordered_json::parse(bad.value);
        const auto result = run_program({"check", scratch.file("bad.json", config_with(parameters))});
        INFO(bad.place << " = " << bad.value << "\n" << result.messages);
        CHECK(result.code == 2);
        const std::string marker = ": /problems/0/parameters" + bad.pointer + ": expected ";
        const auto begin = result.messages.find(marker);
        REQUIRE(begin != std::string::npos);
        const std::string message = result.messages.substr(begin, result.messages.find('\n', begin) - begin);
        CHECK(message.find(bad.phrase) != std::string::npos);
    }
}

TEST_CASE("a mechanism without bodies is refused, with the reason") {
    const ScratchFolder scratch;
    const auto check = [&](const ordered_json& problem) {
        ordered_json config = ordered_json::parse(good_config());
        config["problems"] = {problem};
        const auto result = run_program({"check", scratch.file("bad.json", config.dump(2))});
        CHECK(result.code == 2);
        return result.messages;
    };
    for (const ordered_json& bare : {ordered_json("multibody"), ordered_json{{"name", "multibody"}}}) {
        const std::string message = check(bare);
        CHECK_THAT(message,
                   Catch::Contains("/problems/0: expected the parameters of \"multibody\", at least \"bodies\""));
        CHECK_THAT(message, Catch::Contains("kreisel info multibody"));
    }
    const ordered_json nothing = {{"name", "multibody"}, {"parameters", ordered_json::object()}};
    CHECK_THAT(check(nothing),
               Catch::Contains("/problems/0/parameters: expected the key \"bodies\": a list of bodies, at least one"));
}

TEST_CASE("joints and forces default to none") {
    const ordered_json parameters = {{"bodies", ordered_json::parse(good_mechanism()).at("bodies")}};
    const ParameterValues values = read(parameters);
    CHECK(std::get<std::vector<JointData>>(values.at("joints")).empty());
    CHECK(std::get<std::vector<ForceData>>(values.at("forces")).empty());
}

TEST_CASE("joints of every type are read") {
    const auto joints = entries<JointData>("joints", R"([
        {"type": "spherical", "between": ["ground", "a"], "point": [1, 2, 3]},
        {"type": "revolute", "between": ["a", "b"], "points": [[1, 0, 0], [2, 0, 0]], "axis": [0, 0, 2]},
        {"type": "universal", "between": ["a", "b"], "point": [1, 0, 0], "axes": [[0, 1, 0], [0, 0, 1]]},
        {"type": "prismatic", "between": ["a", "b"], "point": [1, 0, 0], "axes": [[0, 1, 0], [0, 2, 0]]},
        {"type": "cylindrical", "between": ["a", "b"], "point": [1, 0, 0], "axis": [0, 1, 0]},
        {"type": "planar", "between": ["a", "b"], "point": [1, 0, 0], "axis": [0, 1, 0]},
        {"type": "fixed", "between": ["a", "b"], "point": [1, 0, 0]},
        {"type": "distance", "between": ["a", "b"], "points": [[1, 0, 0], [0, 0, 0]], "length": 2,
            "amplitude": 0.5, "frequency": 3},
        {"type": "rolling", "between": ["ground", "b"], "points": [[0, 0, 0], [0, 0, 1]], "axes": [[0, 0, 1],
            [1, 0, 0]], "radius": 1},
        {"type": "screw", "between": ["a", "b"], "point": [1, 0, 0], "axis": [0, 1, 0], "lead": -0.5},
        {"type": "cylindrical", "between": ["a", "b"], "point": [1, 0, 0], "axis": [0, 1, 0],
            "turn": {"polynomial": [0, 3]},
            "shift": {"sinusoids": [{"amplitude": 2, "frequency": 3}, {"amplitude": 1, "frequency": 2, "phase": 4}]}},
        {"type": "gear", "between": ["a", "b"], "points": [[1, 0, 0], [0, 0, 0]], "axis": [0, 0, 1], "teeth": [20, -30]},
        {"type": "rack", "between": ["a", "b"], "points": [[1, 0, 0], [0, 0, 0]], "axes": [[0, 1, 0], [0, 0, 1]]}
    ])");
    const Vector3 i = {1, 0, 0}, j = {0, 1, 0}, k = {0, 0, 1}, zero = {0, 0, 0};
    REQUIRE(joints.size() == 13);
    CHECK(joints[0] == JointData{"spherical", {"ground", "a"}, {{{1, 2, 3}, {1, 2, 3}}}});
    CHECK(joints[1] == JointData{"revolute", {"a", "b"}, {{i, {2, 0, 0}}}, {{{0, 0, 2}, {0, 0, 2}}}});
    CHECK(joints[2] == JointData{"universal", {"a", "b"}, {i, i}, {j, k}});
    CHECK(joints[3] == JointData{"prismatic", {"a", "b"}, {i, i}, {{j, {0, 2, 0}}}});
    CHECK(joints[4] == JointData{"cylindrical", {"a", "b"}, {i, i}, {j, j}});
    CHECK(joints[5] == JointData{"planar", {"a", "b"}, {i, i}, {j, j}});
    CHECK(joints[6] == JointData{"fixed", {"a", "b"}, {i, i}});
    CHECK(joints[7] == JointData{"distance", {"a", "b"}, {i, zero}, {}, 2, 0.5, 3});
    CHECK(joints[8] == JointData{"rolling", {"ground", "b"}, {zero, k}, {k, i}, 1});
    JointData screw{"screw", {"a", "b"}, {i, i}, {j, j}}, driven{"cylindrical", {"a", "b"}, {i, i}, {j, j}};
    screw.lead = -0.5;
    driven.turn = MotionData{{0, 3}, {}}, driven.shift = MotionData{{}, {{2, 3, 0}, {1, 2, 4}}};
    CHECK(joints[9] == screw);
    CHECK(joints[10] == driven);
    JointData gear{"gear", {"a", "b"}, {i, zero}, {k, k}};
    gear.teeth = {20, -30};
    CHECK(joints[11] == gear);
    CHECK(joints[12] == JointData{"rack", {"a", "b"}, {i, zero}, {j, k}});
}

TEST_CASE("forces of every type are read") {
    const auto forces = entries<ForceData>("forces", R"([
        {"type": "spring", "between": ["ground", "a"], "points": [[1, 0, 0], [0, 1, 0]], "stiffness": 5,
            "damping": 2, "length": 0},
        {"type": "spring", "between": ["ground", "a"], "points": [[1, 0, 0], [0, 1, 0]], "stiffness": 0},
        {"type": "torsion_spring", "between": ["a", "b"], "axis": [0, 0, 1], "stiffness": 5, "angle": -0.5,
            "turns": -2},
        {"type": "torque", "body": "a", "value": [1, 0, 0], "frame": "body", "amplitude": 0.5, "frequency": 3},
        {"type": "force", "body": "a", "value": [1, 0, 0], "frame": "space", "point": [0, 0, 1]},
        {"type": "force", "body": "a", "value": [0, 1, 0]},
        {"type": "polynomial_spring", "between": ["ground", "a"], "points": [[1, 0, 0], [0, 1, 0]],
            "coefficients": [3, 0, 2]},
        {"type": "damper", "between": ["a", "b"], "point": [1, 0, 0], "damping": 2},
        {"type": "rotational_damper", "between": ["a", "b"], "damping": 2},
        {"type": "bushing", "between": ["a", "b"], "point": [1, 0, 0], "stiffness": [1, 2, 3],
            "torsional_stiffness": [4, 5, 6], "torsional_damping": [0, 0, 1],
            "axes": [[0, 0, 1], [1, 0, 0], [0, 1, 0]]},
        {"type": "gravitation", "between": ["a", "b"], "constant": 2},
        {"type": "central_field", "body": "a", "mu": 3, "centre": [0, 1, 0]}
    ])");
    REQUIRE(forces.size() == 12);
    const std::array<Vector3, 2> ij = {{{1, 0, 0}, {0, 1, 0}}};
    CHECK(
        forces[0] ==
        ForceData{.type = "spring", .between = {"ground", "a"}, .points = ij, .stiffness = 5, .damping = 2, .rest = 0});
    CHECK(forces[1] == ForceData{.type = "spring", .between = {"ground", "a"}, .points = ij});
    CHECK(forces[2] ==
          ForceData{.type = "torsion_spring", .between = {"a", "b"}, .stiffness = 5, .rest = -0.5, .turns = -2});
    CHECK(forces[3] == ForceData{.type = "torque",
                                 .between = {"", "a"},
                                 .value = {1, 0, 0},
                                 .body_axes = true,
                                 .amplitude = 0.5,
                                 .frequency = 3});
    CHECK(forces[4] == ForceData{.type = "force", .between = {"", "a"}, .value = {1, 0, 0}, .point = Vector3{0, 0, 1}});
    CHECK(forces[5] == ForceData{.type = "force", .between = {"", "a"}, .value = {0, 1, 0}});
    CHECK(forces[6] ==
          ForceData{.type = "polynomial_spring", .between = {"ground", "a"}, .points = ij, .coefficients = {3, 0, 2}});
    CHECK(forces[7] == ForceData{.type = "damper", .between = {"a", "b"}, .damping = 2, .point = ij[0]});
    CHECK(forces[8] == ForceData{.type = "rotational_damper", .between = {"a", "b"}, .damping = 2});
    CHECK(forces[9] == ForceData{.type = "bushing",
                                 .between = {"a", "b"},
                                 .axes = {0, 0, 1, 1, 0, 0, 0, 1, 0},
                                 .stiffnesses = {{{1, 2, 3}, {4, 5, 6}}},
                                 .dampings = {{{0, 0, 0}, {0, 0, 1}}},
                                 .point = ij[0]});
    CHECK(forces[10] == ForceData{.type = "gravitation", .between = {"a", "b"}, .attraction = 2});
    CHECK(forces[11] ==
          ForceData{.type = "central_field", .between = {"", "a"}, .attraction = 3, .point = Vector3{0, 1, 0}});
}

TEST_CASE("a joint may have a name") {
    const std::string named =
        R"([{"type": "fixed", "name": "weld_1", "between": ["ground", "a"], "point": [1, 2, 3]}])";
    CHECK(entries<JointData>("joints", named)[0].name == "weld_1");
    const ParameterValues values =
        read({{"bodies", ordered_json::parse(good_mechanism()).at("bodies")}, {"joints", ordered_json::parse(named)}});
    CHECK(read(ordered_json::parse(json_value(values))) == values);
}

TEST_CASE("lists of joints and forces may be empty") {
    CHECK(entries<JointData>("joints", "[]").empty());
    CHECK(entries<ForceData>("forces", "[]").empty());
}

TEST_CASE("a unit quaternion represents its rotation") {
    const auto R = [](const std::string& quaternion) {
        return entries<BodyData>("bodies",
                                 R"([{"name": "a", "mass": 1, "inertia": [1, 1, 1], "x": [0, 0, 0], "quaternion": )" +
                                     quaternion + "}]")[0]
            .R;
    };
    const auto near = [](const Matrix3& a, const Matrix3& b) {
        double sum = 0;
        for (std::size_t i = 0; i < 9; ++i) { sum += std::abs(a[i] - b[i]); }
        return sum < 1e-14;
    };
    CHECK(R("[1, 0, 0, 0]") == identity3);
    CHECK(near(R("[0.5, 0.5, 0.5, 0.5]"), {0, 0, 1, 1, 0, 0, 0, 1, 0}));  // x to y to z to x
    CHECK(near(R("[0.6, 0, 0, 0.8]"), {-0.28, -0.96, 0, 0.96, -0.28, 0, 0, 0, 1}));
    CHECK(near(R("[0.6, 0.8, 0, 0]"), {1, 0, 0, 0, -0.28, -0.96, 0, 0.96, -0.28}));
    CHECK(near(R("[0.6, 0, 0.8, 0]"), {-0.28, 0, 0.96, 0, 1, 0, -0.96, 0, -0.28}));
    CHECK(near(R("[0.6000000003, 0, 0, 0.8000000004]"), {-0.28, -0.96, 0, 0.96, -0.28, 0, 0, 0, 1}));
}

TEST_CASE("a mechanism of a config is written so that it reads back") {
    const ordered_json good = ordered_json::parse(good_mechanism());
    for (const ordered_json& parameters : {good, ordered_json{{"bodies", good.at("bodies")}}}) {
        const ParameterValues values = read(parameters);
        CHECK(read(ordered_json::parse(json_value(values))) == values);
    }
}
