// SPDX-License-Identifier: BSD-3-Clause
//
// The JSON Schema and the reader agree: on the shipped configs, on the bad ones, and on thousands of mutants.
#include "driver/config/schema.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <random>
#include <set>

#include "driver/config/config.hpp"
#include "records/json/strict.hpp"
#include "support/errors.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/config/bad_configs.hpp"
#include "tests/driver/config/bad_mechanisms.hpp"
#include "tests/driver/config/schema_checker.hpp"

using namespace kreisel;
using nlohmann::json;

namespace {

json mechanism_with(const std::string& place, const std::string& value) {
    json config = json::parse(good_config());
    json parameters = json::parse(good_mechanism());
    parameters[json::json_pointer(place)] = json::parse(value);
    config["problems"] = {{{"name", "multibody"}, {"parameters", parameters}}};
    return config;
}

struct Reading {
    std::string error;
    bool shape = false;  ///< that is wrong
};

Reading reading_of(const json& config, const Catalogue& catalogue) {
    try {
        read_config(parse_document("m.json", config.dump()), catalogue);
        return {};
    } catch (const Refusal& refusal) {
        return {refusal.what(), std::any_of(refusal.issues.begin(), refusal.issues.end(),
                                            [](const Issue& issue) { return issue.rule == Rule::shape; })};
    }
}

const std::vector<json>& replacements() {
    static const std::vector<json> values = {nullptr,
                                             true,
                                             -1,
                                             2.5,
                                             5'000'000'000,
                                             0,
                                             7,
                                             "",
                                             "heavy_top",
                                             "exp",
                                             "a\tb",
                                             json::array(),
                                             json::object(),
                                             json::array({1, 2, 3}),
                                             json::array({"rkmk/rk4"}),
                                             json{{"name", "rkmk/rk4"}},
                                             1e300};
    return values;
}

// All places in a value, as JSON pointers.
void collect(const json& value, const json::json_pointer& at, std::vector<json::json_pointer>& places) {
    places.push_back(at);
    if (value.is_object()) {
        for (const auto& [key, member] : value.items()) { collect(member, at / key, places); }
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) { collect(value[i], at / i, places); }
    }
}

json mutant(const json& config, std::mt19937& random) {
    json result = config;
    std::vector<json::json_pointer> places;
    collect(config, json::json_pointer(), places);
    const auto place = places[1 + random() % (places.size() - 1)];
    json& parent = result[place.parent_pointer()];
    switch (random() % 4) {
        case 0:
            if (parent.is_object()) {
                parent.erase(place.back());
            } else {
                parent.erase(std::stoul(place.back()));
            }
            break;
        case 1:
            if (parent.is_object()) {
                parent[place.back() + "x"] = parent[place.back()];
                parent.erase(place.back());
            }
            break;
        default:
            result[place] = replacements()[random() % replacements().size()];
    }
    return result;
}

std::vector<json> shipped_configs() {
    std::vector<json> configs = {json::parse(good_config()),
                                 json::parse(R"({"name": "all", "kind": "drift", "description": "d",
        "precision": ["double", "quad"], "formulations": ["SE3"],
        "problems": [{"name": "heavy_top", "label": "l", "parameters": {"inertia": [1, 1, 1],
            "lever": [0, 1, 0], "mass": 3,
                      "R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "gravity_amplitude": -1}},
                     {"name": "double_pendulum", "parameters": {"bodies": [
                      {"name": "a", "mass": 1, "inertia": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "x": [0, 0, 0],
                          "v": [0, 0, 0], "omega": [0, 0, 0]}]}}],
        "methods": [{"name": "rkmk/rk4", "dexpinv": [0, "seed"]}, {"name": "baseline/rk4_quaternion",
            "renormalise": [true, false]},
                    {"name": "fake/relaxed", "rho": 0.25},
                    {"name": "fake/tableau", "a": [[], ["-1/2"], [0, "0.5"]], "b": [1, "2/3"], "label": "of lists"},
                    {"name": "fake/tableau", "a": "1/2; -3 0.25", "b": "1 2/3", "order": 3}],
        "projections": ["none", {"name": "terze", "weight": ["mass", "identity"]}],
        "time": {"end": 1, "step": [0.5, 0.25]}, "metrics": ["defect.*"], "output": {"samples": 2},
            "figure": [{"kind": "drift", "title": "t", "select": {"formulation": "SE3", "steps": [2, 4]},
                        "metric": ["defect.position"], "facet": "method", "columns": 3},
                       {"kind": "invariants", "name": "energy", "relative": true},
                       {"kind": "components", "name": "c", "body": "top", "until": 0.5, "quantity": "omega",
                        "stacked": true},
                       {"kind": "motion", "name": "m", "view": [60, 30], "instants": 5, "radius": 1,
                        "lever": [0, 0, 1]}]})"),
                                 json::parse(R"({"name": "w", "kind": "work_precision", "problems": ["heavy_top"],
        "methods": ["fake/pair", "rkmk/rk4"], "output": {"samples": 4, "dense": false},
        "time": {"end": 1, "steps": [4, 8], "tolerance": {"from": 1e-3, "levels": 4, "factor": 100},
                 "controller": "pid"},
        "figure": [{"kind": "work_precision", "x": "cpu", "labels": true,
                    "metric": ["error.position", "invariant.energy"]},
                   {"kind": "convergence", "name": "c", "x": "evaluations", "select": {"tolerance": [1e-3, 1e-5]}}]})"),
                                 json::parse(R"({"name": "t", "kind": "convergence", "problems": ["heavy_top"],
        "methods": ["fake/pair"], "time": {"end": 1, "tolerance": [1e-3, 1e-4]}})"),
                                 json::parse(R"({"name": "b", "kind": "drift", "problems": ["heavy_top"],
        "methods": ["rkmk/rk4"], "time": {"end": 1, "steps": 4, "begin": {"t": "0.5", "turns": {"ground-top": -2},
        "bodies": [{"name": "top", "x": [0, 1, "-1.25e-3"], "R": [[1, 0, 0], [0, 1, 0], [0, 0, "1.0"]],
                    "v": [0, 0, 0], "omega": [0, 150, 0]}]}}})"),
                                 mechanism_with("/project_initial", "true"),
                                 mechanism_with("/joints/0", R"({"type": "rolling", "between": ["ground", "rod"],
        "points": [[0, 0, 0], [0, 0, 1]], "axes": [[0, 0, 1], [1, 0, 0]], "radius": 1})")};
    return configs;
}

}  // namespace

TEST_CASE("schema and reader agree on good configs and on every bad one") {
    const Catalogue catalogue{FakeEngine()};
    SchemaChecker schema(catalogue);
    for (const json& config : shipped_configs()) {
        CHECK(reading_of(config, catalogue).error == "");
        CHECK(schema.accepts(config));
    }
    for (const BadConfig& bad : bad_configs()) {
        json config = json::parse(good_config());
        config.merge_patch(json::parse(bad.patch));
        const Reading reading = reading_of(config, catalogue);
        INFO(bad.patch << "\n" << reading.error);
        CHECK(schema.accepts(config) != reading.shape);
    }
    for (const BadMechanism& bad : bad_mechanisms()) {
        const json config = mechanism_with(bad.place, bad.value);
        const Reading reading = reading_of(config, catalogue);
        INFO(bad.place << " = " << bad.value << "\n" << reading.error);
        CHECK_FALSE(reading.error.empty());
        CHECK(schema.accepts(config) != reading.shape);
    }
}

TEST_CASE("schema and reader agree on three thousand mutants") {
    const Catalogue catalogue{FakeEngine()};
    SchemaChecker schema(catalogue);
    std::mt19937 random(20260103);
    const auto configs = shipped_configs();
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        const json config = mutant(configs[random() % configs.size()], random);
        const Reading reading = reading_of(config, catalogue);
        INFO(config.dump() << "\n" << reading.error);
        REQUIRE(schema.accepts(config) != reading.shape);
        refused += reading.error.empty() ? 0 : 1;
    }
    CHECK(refused > 2000);
}

TEST_CASE("the schema accepts configs that extend others, in parts, and checks their keys") {
    SchemaChecker schema{Catalogue(plain_engine)};
    CHECK(schema.accepts(json::parse(R"({"extends": "good.json", "time": {"end": 2}})")));
    CHECK_FALSE(schema.accepts(json::parse(R"({"extends": "good.json", "tome": {"end": 2}})")));
    CHECK_FALSE(schema.accepts(json::parse(R"({"extends": 3})")));
    CHECK_FALSE(schema.accepts(json::parse(R"({"time": {"end": 2}})")));
}
