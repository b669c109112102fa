// SPDX-License-Identifier: BSD-3-Clause
//
// The parameters of every registered problem survive the round trip through a config: written, read, written again.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "driver/config/composition/composed.hpp"
#include "driver/config/config.hpp"
#include "driver/config/resolved.hpp"
#include "driver/config/shipped.hpp"
#include "engine/engine.hpp"
#include "kreisel_build.hpp"
#include "mechanics/parts/driven_joints.hpp"
#include "records/json/strict.hpp"
#include "records/json/writer.hpp"

using namespace kreisel;

namespace {

/// A number with all 53 bits in use, close to x.
double awkward(double x) { return x * (1 + 1 / (3 * 1024.0)) + std::nextafter(1.0 / 3, 0); }

Vector3 awkward(const Vector3& v) { return {awkward(v[0]), awkward(v[1]), awkward(v[2])}; }

/// Symmetric to the last bit; a rotation that permutes the axes cyclically stays one.
Matrix3 awkward(const Matrix3& m, ParameterKind kind) {
    if (kind == ParameterKind::rotation) return {m[3], m[4], m[5], m[6], m[7], m[8], m[0], m[1], m[2]};
    const double a = awkward(m[1]) / 7, b = awkward(m[2]) / 7, c = awkward(m[5]) / 7;
    return {awkward(m[0]), a, b, a, awkward(m[4]), c, b, c, awkward(m[8])};
}

std::vector<JointData> joints_of_all_types() {
    std::vector<JointData> joints;
    for (const JointKind& kind : joint_kinds()) {
        JointData joint{.type = kind.name, .between = {"ground", "rod"}};
        joint.points = {awkward(Vector3{1, 0, 2}), awkward(Vector3{0, 3, 2})};
        if (kind.axes != JointAxes::none) joint.axes = {awkward(Vector3{1, 1, 0}), awkward(Vector3{0, 1, 1})};
        if (kind.has(Primitive::distance)) joint.amplitude = awkward(0.2), joint.frequency = awkward(3);
        if (kind.has(Primitive::contact)) joint.length = awkward(0.7);
        if (kind.has(Primitive::helix)) joint.lead = awkward(-0.3);
        if (kind.has(Primitive::mesh)) joint.teeth = {17, -23};
        const Drive drive = drivable(kind);
        if (drive.turn) joint.turn = {{0, awkward(0.5)}, {{awkward(0.1), awkward(2), awkward(0)}}};
        if (drive.shift) joint.shift = {{}, {{awkward(0.1), awkward(-2), awkward(0)}}};
        joints.push_back(joint);
    }
    const auto rod = [](const JointData& joint) { return joint.type == "distance"; };
    joints.push_back(*std::find_if(joints.begin(), joints.end(), rod));  // that one has the initial length
    joints.back().length = awkward(2);
    return joints;
}

std::vector<ForceData> forces_of_all_types() {
    const std::array<Vector3, 2> points = {awkward(Vector3{1, 0, 2}), awkward(Vector3{0, 3, 2})};
    ForceData spring{.type = "spring", .between = {"crank", "rod"}, .points = points, .stiffness = awkward(10)};
    ForceData damper = spring;
    damper.damping = awkward(3), damper.rest = awkward(0.4);
    ForceData torsion{.type = "torsion_spring",
                      .between = {"ground", "rod"},
                      .axis = awkward(Vector3{1, 0, 2}),
                      .stiffness = awkward(7),
                      .damping = awkward(0.1),
                      .rest = awkward(-0.5),
                      .turns = -12};
    ForceData torque{.type = "torque",
                     .between = {"", "rod"},
                     .value = awkward(Vector3{1, 0, 2}),
                     .amplitude = awkward(0.5),
                     .frequency = awkward(5)};
    ForceData force = torque, pushed = torque;
    force.type = pushed.type = "force";
    pushed.point = awkward(Vector3{0, 1, 0}), pushed.body_axes = true;
    ForceData polynomial{.type = "polynomial_spring",
                         .between = {"crank", "rod"},
                         .points = points,
                         .damping = awkward(3),
                         .coefficients = {awkward(2), -awkward(1)}};
    ForceData resisting{.type = "damper", .between = {"crank", "rod"}, .damping = awkward(2), .point = points[1]};
    ForceData turning{.type = "rotational_damper", .between = {"crank", "rod"}, .damping = awkward(2)};
    ForceData bushing{.type = "bushing",
                      .between = {"crank", "rod"},
                      .axes = awkward(identity3, ParameterKind::rotation),
                      .stiffnesses = points,
                      .dampings = {points[1], points[0]},
                      .point = points[0]};
    ForceData gravitation{.type = "gravitation", .between = {"crank", "rod"}, .attraction = awkward(2)};
    ForceData central{.type = "central_field", .between = {"", "rod"}, .attraction = awkward(2)}, off_centre = central;
    off_centre.point = points[0];
    return {spring,    damper,  torsion, torque,      force,   pushed,    polynomial,
            resisting, turning, bushing, gravitation, central, off_centre};
}

/// `shown`: the value in the demonstration of the problem.
ParameterValue other_than_standard(const ParameterDescription& parameter, const ParameterValue& shown) {
    switch (parameter.kind) {
        case ParameterKind::scalar:
        case ParameterKind::positive:
            return awkward(std::get<double>(parameter.standard));
        case ParameterKind::count:
            return std::get<double>(parameter.standard) + 1;
        case ParameterKind::vector:
            return awkward(std::get<Vector3>(parameter.standard));
        case ParameterKind::inertia:
        case ParameterKind::rotation:
            return awkward(std::get<Matrix3>(parameter.standard), parameter.kind);
        case ParameterKind::flag:
            return !std::get<bool>(parameter.standard);
        case ParameterKind::joints:
            return joints_of_all_types();
        case ParameterKind::forces:
            return forces_of_all_types();
        case ParameterKind::bodies:
            break;
    }
    auto bodies = std::get<std::vector<BodyData>>(shown);
    for (BodyData& body : bodies) {
        body.mass = awkward(body.mass);
        body.inertia = awkward(body.inertia, ParameterKind::inertia);
        body.R = awkward(body.R, ParameterKind::rotation);
        body.x = awkward(body.x), body.omega = awkward(body.omega.value_or(Vector3{})), body.v = awkward(body.x);
    }
    bodies.back().v.reset(), bodies.front().omega.reset();  // absent stays absent
    bodies.push_back({.name = "point", .mass = awkward(0.2), .x = awkward(Vector3{1, 2, 3}), .point = true});
    return bodies;
}

ParameterValues read_back(const std::string& problem, const std::string& parameters, const Catalogue& catalogue) {
    const std::string text =
        ObjectWriter()
            .member("name", json_text("round_trip"))
            .member("kind", json_text("convergence"))
            .member(
                "problems",
                "[" + ObjectWriter().member("name", json_text(problem)).member("parameters", parameters).text() + "]")
            .member("formulations", R"(["SO3xR3"])")
            .member("methods", R"(["rkmk/rk4"])")
            .member("time", R"({"end": 1, "steps": [8, 16]})")
            .text();
    return read_config(parse_document("round_trip.json", text), catalogue).problems.at(0).parameters();
}

}  // namespace

TEST_CASE("parameters of every problem round-trip through JSON", "[campaign]") {
    const Catalogue catalogue(engine_binary64());
    for (const ProblemDescription& problem : catalogue.problems) {
        INFO(problem.name);
        const ParameterValues standard = demonstration_parameters(problem);
        ParameterValues other;
        for (const ParameterDescription& parameter : problem.parameters) {
            other[parameter.name] = other_than_standard(parameter, standard.at(parameter.name));
            INFO(parameter.name);
            CHECK_FALSE(other[parameter.name] == parameter.standard);
        }
        CHECK(read_back(problem.name, json_value(standard), catalogue) == standard);
        CHECK(read_back(problem.name, json_value(other), catalogue) == other);
        if (required_parameters(problem).empty()) CHECK(read_back(problem.name, "{}", catalogue) == standard);
    }
}

TEST_CASE("a number of parts is a whole one, alone or in a list, for the reader and for the problem itself",
          "[campaign]") {
    const Catalogue catalogue(engine_binary64());
    int counts = 0;
    for (const ProblemDescription& problem : catalogue.problems)
        for (const ParameterDescription& parameter : problem.parameters) {
            if (parameter.kind != ParameterKind::count) continue;
            ++counts;
            const auto read = [&](const std::string& value) {
                return read_back(problem.name, ObjectWriter().member(parameter.name, value).text(), catalogue);
            };
            INFO(problem.name << " " << parameter.name);
            CHECK(read("3").at(parameter.name) == ParameterValue(3.0));
            CHECK(read("[3, 4]").at(parameter.name) == ParameterValue(3.0));
            CHECK(read("1e3").at(parameter.name) == ParameterValue(1000.0));
            for (const char* value :
                 {"2.5", "[2, 2.5]", "2.000000000000001", "0", "-1", "1000001", "[2, 0]", "true", "1e7"})
                CHECK_THROWS_WITH(read(value), Catch::Contains("/problems/0/parameters/" + parameter.name) &&
                                                   Catch::Contains("a whole number from 1 to 1000000"));
            for (const double value : {2.5, 0.0, -1.0, 1000001.0, std::nextafter(2.0, 3)}) {
                ParameterValues values;
                for (const ParameterDescription& other : problem.parameters) values[other.name] = other.standard;
                values[parameter.name] = value;
                CHECK_THROWS_AS(engine_binary64().summary(problem.name, values, "SO3xR3"), ParameterError);
            }
        }
    CHECK(counts >= 3);  // windows, links, masses
}

TEST_CASE("a round trip that loses a bit is noticed", "[campaign][control]") {
    const Catalogue catalogue(engine_binary64());
    const ProblemDescription& problem = catalogue.problems.at(0);
    ParameterValues values;
    for (const ParameterDescription& parameter : problem.parameters)
        values[parameter.name] = other_than_standard(parameter, parameter.standard);
    const ParameterValues back = read_back(problem.name, json_value(values), catalogue);
    for (auto& [name, value] : values)
        if (auto* vector = std::get_if<Vector3>(&value)) (*vector)[2] = std::nextafter((*vector)[2], 1e9);
    CHECK_FALSE(back == values);
}

TEST_CASE("the parameters of a shipped config are the same to the last sign when its manifest is read", "[campaign]") {
    const Catalogue catalogue(engine_binary64());
    const auto written = [](const Config& config) {
        std::string text;
        for (const ProblemPoint& problem : config.problems) text += json_value(problem.parameters()) + "\n";
        return text;
    };
    for (const auto& [name, file] : configs_below(std::filesystem::path(build::source_dir) / "experiments")) {
        INFO(name);
        const Config config = read_config(composed_config(file), catalogue);
        const Config again = read_config(parse_document("manifest.json", resolved_config(config)), catalogue);
        CHECK(written(config) == written(again));
    }
}
