// SPDX-License-Identifier: BSD-3-Clause
//
// Joints in results: names and units of multipliers, reactions on the second-named body, which of them are unique,
// and metrics with one unit each.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"
#include "tests/campaign/acceptance.hpp"

using namespace kreisel;
using nlohmann::ordered_json;

namespace {

const Engines both_engines{engine_binary64(), engine_binary128()};

/// A hinge on the x axis that holds a beam of 2 kg half a metre out.
const char* const beam = R"({
    "gravity": [0, 0, -9.81], "forces": [],
    "bodies": [{"name": "beam", "mass": 2, "inertia": [0.2, 0.2, 0.2], "x": [0.5, 0, 0]}],
    "joints": [{"type": "revolute", "between": ["ground", "beam"], "point": [0, 0, 0], "axis": [1, 0, 0]}]})";
const char* const wheel = R"({
    "gravity": [0, 0, -9.81], "forces": [],
    "bodies": [{"name": "wheel", "mass": 1, "inertia": [0.0625, 0.0625, 0.125], "x": [0, 0, 0.5],
                "R": [[1, 0, 0], [0, 0, -1], [0, 1, 0]], "omega": [0, 0, 2]}],
    "joints": [{"type": "rolling", "between": ["ground", "wheel"], "points": [[0, 0, 0], [0, 0, 0.5]],
                "axes": [[0, 0, 1], [0, -1, 0]], "radius": 0.5}]})";
const char* const block = R"({
    "gravity": [0, 0, -9.81], "forces": [],
    "bodies": [{"name": "block", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [0, 0, 0]}],
    "joints": [{"type": "planar", "between": ["ground", "block"], "point": [0, 0, 0], "axis": [0, 0, 1]}]})";
/// Two bodies 5 m apart under each force that acts between two.
const char* const bound = R"({
    "gravity": [0, 0, 0], "joints": [],
    "bodies": [{"name": "a", "mass": 2, "inertia": [1, 1, 1], "x": [0, 0, 0]},
               {"name": "b", "mass": 3, "inertia": [1, 1, 1], "x": [3, 4, 0], "v": [1, 0, 0], "omega": [0, 0, 1]}],
    "forces": [
        {"type": "spring", "between": ["a", "b"], "points": [[0, 0, 0], [3, 4, 0]], "stiffness": 10, "length": 1},
        {"type": "spring", "between": ["a", "b"], "points": [[0, 0, 0], [3, 5, 0]], "stiffness": 0, "damping": 0},
        {"type": "spring", "between": ["b", "ground"], "points": [[3, 4, 0], [3, 5, 0]], "stiffness": 7,
         "length": 0},
        {"type": "polynomial_spring", "between": ["a", "b"], "points": [[0, 0, 0], [3, 4, 0]],
         "coefficients": [1, 1], "length": 3},
        {"type": "gravitation", "between": ["a", "b"], "constant": 25},
        {"type": "central_field", "body": "b", "mu": 25},
        {"type": "damper", "between": ["ground", "b"], "point": [3, 6, 0], "damping": 3},
        {"type": "rotational_damper", "between": ["a", "b"], "damping": 2},
        {"type": "torsion_spring", "between": ["b", "a"], "axis": [0, 0, 1], "stiffness": 5, "angle": 0.5},
        {"type": "bushing", "between": ["a", "b"], "point": [3, 6, 0], "stiffness": [1, 1, 1],
         "torsional_stiffness": [1, 1, 1], "damping": [2, 4, 5], "torsional_damping": [3, 6, 7]}]})";
/// A door on two hinges, which share its weight in an undetermined way, and a bell on a ball joint below it.
const char* const door = R"({
    "gravity": [0, 0, -9.81], "forces": [],
    "bodies": [{"name": "door", "mass": 4, "inertia": [1, 1, 1], "x": [0.5, 0, 0]},
               {"name": "bell", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [1, 0, -2]}],
    "joints": [{"type": "revolute", "name": "upper", "between": ["ground", "door"], "point": [0, 0, 1],
        "axis": [0, 0, 1]},
               {"type": "revolute", "name": "lower", "between": ["ground", "door"], "point": [0, 0, -1],
                   "axis": [0, 0, 1]},
               {"type": "spherical", "between": ["door", "bell"], "point": [1, 0, -1]}]})";

std::vector<Cell> cells_of(const char* parameters, const std::vector<std::string>& formulations,
                           const std::string& precision) {
    ordered_json config = {{"name", "reactions"}, {"kind", "drift"}, {"methods", {"rkmk/rk4"}}};
    config["problems"] = {{{"name", "multibody"}, {"parameters", ordered_json::parse(parameters)}}};
    config["formulations"] = formulations;
    config["precision"] = precision;
    config["time"] = {{"end", 0.01}, {"steps", 10}};
    config["output"] = {{"samples", 1}};
    std::vector<Cell> cells;
    for (const PlannedCell& planned : plan_of(parse_document("reactions.json", config.dump()), both_engines).cells)
        cells.push_back(planned.cell());
    return cells;
}

Outcome outcome_of(const char* parameters) {
    return engine_binary64().run(cells_of(parameters, {"SO3xR3"}, "double").at(0), nullptr, {});
}

bool is_near(const std::array<Number, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0].value - b[0], a[1].value - b[1], a[2].value - b[2]) < 1e-11;
}

std::vector<std::string> cells_in(const std::string& line) {
    std::vector<std::string> all;
    std::istringstream in(line + ",");
    for (std::string one; std::getline(in, one, ',');) all.push_back(one);
    return all;
}

/// The first sample of a trajectory by column, and the unit of each.
std::map<std::string, std::pair<std::string, std::string>> first_sample(const char* parameters) {
    std::map<std::string, std::pair<std::string, std::string>> sample;
    acceptance::Samples samples;
    engine_binary64().run(cells_of(parameters, {"SO3xR3"}, "double").at(0), nullptr, {}, &samples);
    const auto values = cells_in(samples.rows.at(0));
    const auto& columns = samples.columns;
    REQUIRE(values.size() == columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) sample[columns[i].name] = {values[i], columns[i].unit};
    CHECK(sample.size() == columns.size());  // no name occurs twice
    return sample;
}

std::set<std::string> metric_names_of(const Outcome& outcome) {
    std::set<std::string> names;
    for (const auto& metric : outcome.metrics) names.insert(metric.first);
    return names;
}

}  // namespace

TEST_CASE("a hinge holds a beam with its weight and a moment, in every formulation and precision", "[campaign]") {
    for (const char* precision : {"double", "quad"})
        for (const Cell& cell : cells_of(beam, {"SO3xR3", "SE3", "S3xR3"}, precision)) {
            INFO(precision << " " << cell.formulation);
            const Outcome outcome = both_engines.of(precision).run(cell, nullptr, {});
            REQUIRE(outcome.final);
            REQUIRE(outcome.final->reactions.size() == 1);
            const ReportedReaction& reaction = outcome.final->reactions[0];
            CHECK(reaction.joint == "ground-beam");
            CHECK(reaction.unique);
            CHECK(is_near(reaction.force, {0, 0, 19.62}));
            CHECK(is_near(reaction.torque, {0, -9.81, 0}));
            CHECK(outcome.final->multiplier_names ==
                  std::vector<std::string>{"lambda.ground-beam.1 [N]", "lambda.ground-beam.2 [N]",
                                           "lambda.ground-beam.3 [N]", "lambda.ground-beam.4 [N m]",
                                           "lambda.ground-beam.5 [N m]"});
            const auto& lambda = outcome.final->multipliers;
            CHECK(std::abs(lambda[2].value - 19.62) < 1e-11);
            CHECK(std::abs(std::hypot(lambda[3].value, lambda[4].value) - 9.81) < 1e-11);
        }
}

TEST_CASE("a motor that holds a beam is told apart from its hinge, and so is what lifts a table", "[campaign]") {
    ordered_json held = ordered_json::parse(beam);
    held["joints"][0]["turn"] = {{"polynomial", {0}}};
    auto sample = first_sample(held.dump().c_str());
    CHECK(sample.at("drive.ground-beam.torque").second == "N m");
    CHECK(std::abs(std::stod(sample.at("drive.ground-beam.torque").first)) < 1e-11);  // about x nothing turns the beam
    CHECK(std::abs(std::stod(sample.at("reaction.ground-beam.torque.2").first) + 9.81) < 1e-11);
    CHECK_FALSE(sample.contains("drive.ground-beam.force"));
    CHECK(first_sample(beam).count("drive.ground-beam.torque") == 0);

    held["joints"][0]["axis"] = {0, 1, 0};
    const Outcome turned =
        both_engines.of("quad").run(cells_of(held.dump().c_str(), {"SE3"}, "quad").at(0), nullptr, {});
    CHECK(std::abs(turned.final->reactions.at(0).driving_torque->value + 9.81) < 1e-11);
    CHECK(is_near(turned.final->reactions.at(0).torque, {0, 0, 0}));
    CHECK_FALSE(turned.final->reactions.at(0).driving_force);

    held["joints"][0] = {{"type", "prismatic"}, {"between", {"ground", "beam"}}, {"point", {0, 0, 0}}};
    held["joints"][0]["axis"] = {0, 0, 1};
    held["joints"][0]["shift"] = {{"polynomial", {0, 0, 1}}};
    sample = first_sample(held.dump().c_str());
    CHECK(sample.at("drive.ground-beam.force").second == "N");
    CHECK(std::abs(std::stod(sample.at("drive.ground-beam.force").first) - 2 * (9.81 + 2)) < 1e-11);
    CHECK(std::abs(std::stod(sample.at("reaction.ground-beam.force.3").first)) < 1e-11);
}

TEST_CASE("columns of multipliers and reactions have their units", "[campaign]") {
    auto sample = first_sample(beam);
    for (int k = 1; k <= 5; ++k)
        CHECK(sample.at("lambda.ground-beam." + std::to_string(k)).second == (k <= 3 ? "N" : "N m"));
    for (const std::string k : {"1", "2", "3"}) {
        CHECK(sample.at("reaction.ground-beam.force." + k).second == "N");
        CHECK(sample.at("reaction.ground-beam.torque." + k).second == "N m");
    }
    CHECK(std::abs(std::stod(sample.at("reaction.ground-beam.force.3").first) - 19.62) < 1e-11);
    CHECK(std::abs(std::stod(sample.at("reaction.ground-beam.torque.2").first) + 9.81) < 1e-11);
    CHECK_FALSE(sample.contains("reaction.ground-beam.unique"));
}

TEST_CASE("the ground carries a wheel and a block alike, and the other order of bodies changes the sign",
          "[campaign]") {
    const std::array<double, 3> up = {0, 0, 9.81}, down = {0, 0, -9.81};
    for (const char* carried : {wheel, block}) {
        const Outcome outcome = outcome_of(carried);
        CHECK(is_near(outcome.final->reactions.at(0).force, up));
        CHECK(is_near(outcome.final->reactions.at(0).torque, {0, 0, 0}));
        CHECK(std::abs(outcome.final->multipliers.at(0).value - 9.81) < 1e-11);
    }
    ordered_json other = ordered_json::parse(block);
    other["joints"][0]["between"] = {"block", "ground"};
    CHECK(is_near(outcome_of(other.dump().c_str()).final->reactions.at(0).force, down));
}

TEST_CASE("a joint that the formulation eliminates has the same reaction", "[campaign]") {
    ordered_json top = ordered_json::parse(beam);
    top["joints"][0] = {{"type", "spherical"}, {"between", {"ground", "beam"}}, {"point", {0, 0, 0}}};
    top["forces"] = {{{"type", "force"}, {"body", "beam"}, {"value", {1, 2, 3}}, {"frame", "body"}}};
    top["bodies"][0]["omega"] = {1, 2, 3};
    for (const bool reversed : {false, true}) {
        if (reversed) top["joints"][0]["between"] = {"beam", "ground"};
        std::vector<ReportedReaction> reactions;
        for (const Cell& cell : cells_of(top.dump().c_str(), {"SO3xR3", "SO3", "S3"}, "quad"))
            reactions.push_back(engine_binary128().run(cell, nullptr, {}).final->reactions.at(0));
        REQUIRE(reactions.size() == 3);
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(std::abs(reactions[0].force[k].value) > 1e-3);
            for (std::size_t i = 1; i < 3; ++i) {
                CHECK(std::abs(reactions[0].force[k].value - reactions[i].force[k].value) < 1e-9);
                CHECK(reactions[i].torque[k].value == 0);
            }
        }
    }
}

TEST_CASE("columns call joints by their names, or by their bodies and a number", "[campaign]") {
    ordered_json named = ordered_json::parse(block);
    const ordered_json rod = {
        {"type", "distance"}, {"between", {"ground", "block"}}, {"points", {{1, 0, 3}, {0, 0, 0}}}};
    named["joints"] = {rod, rod, rod};
    named["joints"][1]["points"][0] = {-1, 1, 3};
    named["joints"][1]["name"] = "crank_pin";
    named["joints"][2]["points"][0] = {0, -2, 3};
    const auto sample = first_sample(named.dump().c_str());
    for (const char* name : {"lambda.ground-block.1", "lambda.crank_pin.1", "lambda.ground-block-2.1"})
        CHECK(sample.contains(name));
}

TEST_CASE("samples hold what springs, dampers, bushings and attractions exert on their second body", "[campaign]") {
    const auto sample = first_sample(bound);
    std::set<std::string> found;
    const auto check = [&](const std::string& name, const std::string& unit, const std::array<double, 3>& expected) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::string column = "exerted." + name + "." + std::to_string(k + 1);
            CAPTURE(column);
            REQUIRE(sample.contains(column));
            CHECK(sample.at(column).second == unit);
            CHECK(std::abs(std::stod(sample.at(column).first) - expected[k]) < 1e-13);
            found.insert(column);
        }
    };
    check("spring.a-b.force", "N", {-24, -32, 0});
    check("spring.a-b-2.force", "N", {0, 0, 0});
    check("spring.b-ground.force", "N", {0, -7, 0});
    check("polynomial_spring.a-b.force", "N", {-3.6, -4.8, 0});
    check("attraction.a-b.force", "N", {-3.6, -4.8, 0});
    check("attraction.ground-b.force", "N", {-1.8, -2.4, 0});
    check("damper.ground-b.force", "N", {3, 0, 0});  // the point moves with (1 - 2, 0, 0)
    check("rotational_damper.a-b.torque", "N m", {0, 0, -2});
    check("torsion_spring.b-a.torque", "N m", {0, 0, 2.5});
    check("bushing.a-b.force", "N", {2, 0, 0});
    check("bushing.a-b.torque", "N m", {0, 0, -7});
    for (const auto& [column, value] : sample) CHECK((found.contains(column) || !column.starts_with("exerted.")));

    const Cell cell = cells_of(bound, {"SO3xR3"}, "double").at(0);
    std::set<std::string> links;
    for (const LinkGeometry& link : engine_binary64().geometry(cell.problem, cell.parameters).links)
        links.insert(link.name);
    CHECK(links.size() == 10);
    for (const std::string& column : found)
        CHECK(links.contains(column.substr(8, column.rfind('.', column.size() - 3) - 8)));
}

TEST_CASE("with redundant rows, reactions that are not unique are marked, and unique ones stay", "[campaign]") {
    const Outcome outcome = outcome_of(door);
    REQUIRE(outcome.final);
    CHECK(outcome.final->multipliers.empty());
    CHECK(outcome.constraints.least_norm.size() == 13);
    const auto& reactions = outcome.final->reactions;
    REQUIRE(reactions.size() == 3);
    CHECK_FALSE(reactions[0].unique);
    CHECK_FALSE(reactions[1].unique);
    CHECK(reactions[2].unique);
    CHECK(is_near(reactions[2].force, {0, 0, 9.81}));
    CHECK(std::abs(reactions[0].force[2].value + reactions[1].force[2].value - 5 * 9.81) < 1e-9);
    auto sample = first_sample(door);
    CHECK(sample.at("reaction.upper.unique").first == "0");
    CHECK(sample.at("reaction.door-bell.unique").first == "1");
    CHECK(sample.at("lambda.upper.3").first.empty());
    CHECK(std::abs(std::stod(sample.at("lambda.door-bell.3").first) - 9.81) < 1e-11);
    CHECK_FALSE(sample.at("reaction.upper.force.3").first.empty());
}

TEST_CASE("metrics of lengths and of directions are separate, and absent without rows", "[campaign]") {
    const auto hinged = metric_names_of(outcome_of(beam)), carried = metric_names_of(outcome_of(wheel));
    for (const char* level : {"defect.direction", "defect.direction.velocity", "defect.direction.acceleration"}) {
        CHECK(hinged.contains(level));
        CHECK_FALSE(carried.contains(level));
    }
    for (const char* level : {"defect.position", "defect.velocity", "defect.acceleration"}) {
        CHECK(hinged.contains(level));
        CHECK(carried.contains(level));
    }
}

TEST_CASE("errors of forces and of torques are separate", "[campaign]") {
    ordered_json turning = ordered_json::parse(beam);
    turning["bodies"][0]["omega"] = {3, 0, 0};
    turning["bodies"][0]["inertia"] = {0.2, 0.3, 0.4};
    Cell cell = cells_of(turning.dump().c_str(), {"SO3xR3"}, "double").at(0);
    cell.metrics = {"error.*"};
    const Reference reference = engine_binary128().reference(cell.problem, cell.parameters, cell.t_end, {});
    CHECK(reference.error.contains("error.multipliers"));
    CHECK(reference.error.contains("error.multipliers.torque"));
    CHECK(metric_names_of(engine_binary64().run(cell, &reference, {})).contains("error.multipliers.torque"));
    Reference off = reference;
    off.state.multipliers.back() = {off.state.multipliers.back().value + 1, "1e3"};
    std::map<std::string, double> errors;
    for (const auto& [name, value] : engine_binary64().run(cell, &off, {}).metrics) errors[name] = value.value;
    CHECK(errors.at("error.multipliers") < 1e-6);
    CHECK(errors.at("error.multipliers.torque") > 900);
    const ReferenceCheck check = engine_binary128().check_reference(cell.problem, cell.parameters, reference);
    CHECK(check.difference.at("error.multipliers.torque").value < 1e-20);
}
