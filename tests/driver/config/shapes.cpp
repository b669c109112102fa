// SPDX-License-Identifier: BSD-3-Clause
//
// Shapes of bodies: drawings have them, and nothing that is computed or named depends on them.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "driver/config/config.hpp"
#include "driver/config/resolved.hpp"
#include "driver/plan/plan.hpp"
#include "records/geometry.hpp"
#include "records/json/strict.hpp"
#include "tests/driver/command_line.hpp"

namespace kreisel::shapes_of_bodies {

using nlohmann::ordered_json;

// A body that the engine of these tests moves; `shape` is null or a shape.
ordered_json shaped_config(const ordered_json& shape) {
    ordered_json body = {{"name", "top"}, {"mass", 1}, {"inertia", {1, 1, 1}}, {"x", {0, 0, 0}}};
    if (!shape.is_null()) { body["shape"] = shape; }
    ordered_json config = ordered_json::parse(R"({"name": "c", "kind": "trajectory", "methods": ["rkmk/rk4"],
        "time": {"end": 1, "steps": 4}, "output": {"samples": 2}})");
    config["problems"] = {{{"name", "multibody"}, {"parameters", {{"bodies", {body}}}}}};
    return config;
}

Config read_shaped(const ordered_json& config) {
    return read_config(parse_document("c.json", config.dump(2)), Catalogue{FakeEngine()});
}

std::string hash_of_shaped(const ordered_json& config) {
    return plan_of(parse_document("c.json", config.dump(2)), one_engine).cells.at(0).hash();
}

const ordered_json a_rod = {{"type", "rod"}, {"length", 0.5}, {"axis", {1, 0, 0}}};

TEST_CASE("a shape is not a parameter and changes no cell's name") {
    const Config with = read_shaped(shaped_config(a_rod)), without = read_shaped(shaped_config(nullptr));
    CHECK(hash_of_shaped(shaped_config(a_rod)) == hash_of_shaped(shaped_config(nullptr)));
    CHECK(with.problems.at(0).parameters_text() == without.problems.at(0).parameters_text());
    ordered_json heavier = shaped_config(a_rod);
    heavier["problems"][0]["parameters"]["bodies"][0]["mass"] = 2;
    CHECK(hash_of_shaped(heavier) != hash_of_shaped(shaped_config(a_rod)));
}

TEST_CASE("a resolved config has the shapes of each type as they were written, and reads back") {
    for (const char* text : {R"({"type": "cylinder", "radius": 0.1, "length": 0.5})",
                             R"({"type": "box", "size": [0.1, 0.2, 0.3]})", R"({"type": "sphere", "radius": 0.25})",
                             R"({"type": "rod", "radius": 0.01, "length": 2, "axis": [0, 3, 4]})"}) {
        const ordered_json shape = ordered_json::parse(text);
        const std::string resolved = resolved_config(read_shaped(shaped_config(shape)));
        const ordered_json json = ordered_json::parse(resolved);
        CHECK(nlohmann::json(json.at("problems").at(0).at("parameters").at("bodies").at(0).at("shape")) ==
              nlohmann::json(shape));
        CHECK(resolved_config(read_shaped(json)) == resolved);
    }
    const ordered_json plain = ordered_json::parse(resolved_config(read_shaped(shaped_config(nullptr))));
    CHECK_FALSE(plain.at("problems").at(0).at("parameters").at("bodies").at(0).contains("shape"));
}

TEST_CASE("a shape is in the geometry of a run, whose results are the same bytes without it") {
    const ScratchFolder scratch;
    const auto run = [&](const std::string& name, const ordered_json& shape) {
        const std::string config = scratch.file(name + ".json", shaped_config(shape).dump());
        REQUIRE(run_program({"run", config, "-o", (scratch / name).string()}).code == 0);
        return read_geometry(scratch / name).at(0);
    };
    const CellGeometry with = run("with", a_rod), without = run("without", nullptr);
    CHECK(with.shapes == Shapes{{"top", {.type = "rod", .length = 0.5, .axis = Vector3{1, 0, 0}}}});
    CHECK(without.shapes.empty());
    CHECK(with.cells == without.cells);
    const std::string samples = "trajectories/" + with.cells.at(0) + ".csv";
    for (const std::string& file : {std::string("results.csv"), std::string("results.jsonl"), samples}) {
        CHECK(contents(scratch / "with" / file) == contents(scratch / "without" / file));
    }
    CHECK(contents(scratch / "with" / "geometry.json") != contents(scratch / "without" / "geometry.json"));
}

TEST_CASE("values of an axis that differ in a shape only are one value, and bodies of one name have one shape") {
    const ScratchFolder scratch;
    const auto messages = [&](const ordered_json& second) {
        ordered_json config = shaped_config(a_rod);
        auto& bodies = config["problems"][0]["parameters"]["bodies"];
        bodies = {{"axis", {bodies, second["problems"][0]["parameters"]["bodies"]}}};
        const auto result = run_program({"check", scratch.file("c.json", config.dump(2))});
        return result.code == 0 ? "" : result.messages;
    };
    CHECK_THAT(messages(shaped_config(nullptr)), Catch::Contains("each value once"));
    ordered_json heavier = shaped_config(a_rod);
    heavier["problems"][0]["parameters"]["bodies"][0]["mass"] = 2;
    CHECK(messages(heavier) == "");
    heavier["problems"][0]["parameters"]["bodies"][0]["shape"]["length"] = 1;
    CHECK_THAT(messages(heavier), Catch::Contains("bodies of one name with one shape"));
}

}  // namespace kreisel::shapes_of_bodies
