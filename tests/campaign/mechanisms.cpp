// SPDX-License-Identifier: BSD-3-Clause
//
// Mechanisms that are well-formed but inadmissible: each is refused at its error, naming joint and bodies.
// And admissible ones: every type of joint and force, starts that are corrected.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "driver/plan/plan.hpp"
#include "kreisel_build.hpp"
#include "records/json/strict.hpp"
#include "support/errors.hpp"

using namespace kreisel;
using nlohmann::ordered_json;

namespace {

const Engines engines{engine_binary64(), engine_binary64()};

/// Two rods of a chain and a bob: straight along x, at rest.
const char* const good = R"({
    "gravity": [0, 0, -9.81], "forces": [],
    "bodies": [{"name": "crank", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [0.5, 0, 0]},
               {"name": "rod", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [1.5, 0, 0]},
               {"type": "point", "name": "bob", "mass": 1, "x": [2, 0, 0]}],
    "joints": [{"type": "revolute", "between": ["ground", "crank"], "point": [0, 0, 0], "axis": [0, 1, 0]},
               {"type": "spherical", "between": ["crank", "rod"], "point": [1, 0, 0]},
               {"type": "spherical", "between": ["rod", "bob"], "point": [2, 0, 0]}]})";

Plan plan_with(const ordered_json& parameters) {
    ordered_json config = {
        {"name", "mechanism"}, {"kind", "trajectory"}, {"methods", {"rkmk/rk4"}}, {"metrics", ordered_json::array()}};
    config["problems"] = {{{"name", "multibody"}, {"parameters", parameters}}};
    config["formulations"] = {"SO3xR3", "SE3", "S3xR3"};
    config["time"] = {{"end", 1}, {"steps", 100}};
    return plan_of(parse_document("mechanism.json", config.dump(1)), engines);
}

ordered_json changed(const std::vector<std::pair<std::string, std::string>>& changes) {
    ordered_json parameters = ordered_json::parse(good);
    for (const auto& [place, value] : changes)
        parameters[ordered_json::json_pointer(place)] = ordered_json::parse(value);
    return parameters;
}

std::string text_of(const std::string& file) {
    std::ifstream in(std::string(build::source_dir) + "/" + file);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string refusal(const ordered_json& parameters) {
    try {
        plan_with(parameters);
        return "";
    } catch (const UsageError& error) { return error.what(); }
}

struct Bad {
    std::string place, value;  ///< what is put into the good mechanism
    std::string pointer;       ///< location of the error
    std::vector<std::string> phrases;
};

const std::vector<Bad> bad = {
    // names
    {"/joints/1/between/1",
     "\"rdo\"",
     "/joints/1/between/1",
     {"\"ground\", \"crank\", \"rod\", \"bob\"", "got \"rdo\"", "did you mean \"rod\"?"}},
    {"/joints/0/between/0", "\"Ground\"", "/joints/0/between/0", {"did you mean \"ground\"?"}},
    {"/joints/1/between/0", "\"wheel\"", "/joints/1/between/0", {"expected a body", "got \"wheel\""}},
    {"/joints/1/between/1",
     "\"crank\"",
     "/joints/1/between",
     {"joint 1 (crank - crank, spherical)", "two different bodies"}},
    {"/joints/0/between/1", "\"ground\"", "/joints/0/between", {"\"ground\" twice"}},
    {"/bodies/0/name", "\"ground\"", "/bodies/0/name", {"other than \"ground\""}},
    {"/bodies/0/name", "\"a b\"", "/bodies/0/name", {"letters, digits"}},
    // bodies
    {"/bodies/1/inertia", "[1, 1, 3]", "/bodies/1/inertia", {"no body has this inertia"}},
    {"/bodies/1/inertia", "[[1, 1, 0], [1, 1, 0], [0, 0, 2]]", "/bodies/1/inertia", {"positive definite"}},
    {"/bodies/1/R", "[[1, 0, 0], [0, 1, 0], [0, 0.1, 1]]", "/bodies/1/R", {"rotation matrix"}},
    {"/bodies/1/R", "[[1, 0, 0], [0, 1, 0], [0, 0, -1]]", "/bodies/1/R", {"det R = -1"}},
    // points and axes
    {"/joints/0/axis", "[0, 0, 0]", "/joints/0/axis", {"joint 0 (ground - crank, revolute)", "zero vector"}},
    {"/joints/0",
     R"({"type": "revolute", "between": ["ground", "crank"], "point": [0, 0, 0], "axes": [[0, 1, 0], [0, 0, 0]]})",
     "/joints/0/axes/1",
     {"zero vector"}},
    {"/joints/0",
     R"({"type": "revolute", "between": ["ground", "crank"], "points": [[0, 0, 0], [0, 0, 0.02]], "axis": [0, 1, 0]})",
     "",
     {"joint 0 (ground - crank, revolute): 0.02 m", "joint 1 (crank - rod, spherical): 0 m", "position level"}},
    {"/joints/0",
     R"({"type": "revolute", "between": ["ground", "crank"], "point": [0, 0, 0], "axes": [[0, 1, 0], [0, 1, 0.1]]})",
     "",
     {"joint 0 (ground - crank, revolute): 0 m and 0.099", "position level"}},
    {"/joints/1",
     R"({"type": "prismatic", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 0.5, 0]], "axis": [1, 0, 0]})",
     "",
     {"joint 1 (crank - rod, prismatic): 0.5 m"}},
    {"/joints/1",
     R"({"type": "universal", "between": ["crank", "rod"], "point": [1, 0, 0], "axes": [[0, 1, 0], [0, 1, 1]]})",
     "/joints/1/axes",
     {"joint 1 (crank - rod, universal)", "perpendicular", "45 degrees"}},
    {"/joints/1",
     R"({"type": "distance", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 0, 0]]})",
     "/joints/1/points",
     {"joint 1 (crank - rod, distance)", "two different points"}},
    {"/joints/1",
     R"({"type": "distance", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], "length": 1.5})",
     "",
     {"joint 1 (crank - rod, distance): 0.5 m"}},
    {"/joints/1",
     R"({"type": "distance", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], "amplitude": 1})",
     "/joints/1/amplitude",
     {"between -1 and 1", "got 1"}},
    // prescribed coordinates and screws
    {"/joints/0/turn",
     R"({"polynomial": [0.3, 0, 1]})",
     "",
     {"position level", "joint 0 (ground - crank, revolute with driven turn): expected a turn of 0.3 rad, got 0 rad"}},
    {"/joints/0/turn",
     R"({"sinusoids": [{"amplitude": 0.5, "frequency": 2, "phase": 1.5707963267948966}]})",
     "",
     {"position level", "expected a turn of 0.5 rad, got 0 rad"}},
    {"/joints/0",
     R"({"type": "revolute", "between": ["ground", "crank"], "point": [0, 0, 0], "axes": [[0, 1, 0], [0, -1, 0]], )"
     R"("turn": {"polynomial": [0]}})",
     "/joints/0/axes",
     {"joint 0 (ground - crank, revolute)", "point the same way", "180 degrees apart"}},
    {"/joints/1",
     R"({"type": "cylindrical", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], "axis": [1, 0, 0], )"
     R"("turn": {"polynomial": [0, 1]}, "shift": {"polynomial": [0.25]}})",
     "",
     {"joint 1 (crank - rod, cylindrical with driven turn and shift): expected a shift of", "position level"}},
    {"/joints/1",
     R"({"type": "screw", "between": ["crank", "rod"], "point": [1, 0, 0], "axis": [1, 0, 0], "lead": 0})",
     "/joints/1/lead",
     {"joint 1 (crank - rod, screw)", "expected a lead in m, not 0", "got 0"}},
    {"/joints/1",
     R"({"type": "screw", "between": ["crank", "rod"], "point": [1, 0, 0], "axes": [[1, 0, 0], [-1, 0, 0]], )"
     R"("lead": 0.1})",
     "/joints/1/axes",
     {"joint 1 (crank - rod, screw)", "point the same way"}},
    {"/joints/1",
     R"({"type": "screw", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 0.5, 0]], "axis": [1, 0, 0], )"
     R"("lead": 0.1})",
     "",
     {"position level", "joint 1 (crank - rod, screw): 0.5 m"}},
    {"/joints/1",
     R"({"type": "prismatic", "between": ["crank", "bob"], "points": [[1, 0, 0], [2, 0, 0]], "axis": [1, 0, 0], )"
     R"("shift": {"polynomial": [0, 1]}})",
     "/joints/1/between/1",
     {"joint 1 (crank - bob, prismatic)", "\"bob\" is a point mass"}},
    // wheels that mesh
    {"/joints/1",
     R"({"type": "gear", "between": ["crank", "rod"], "points": [[0, 0, 0], [2, 0, 0]], "axis": [0, 1, 0], )"
     R"("teeth": [1001, 30]})",
     "/joints/1/teeth/0",
     {"joint 1 (crank - rod, gear)", "from 1 to 1000", "got 1001"}},
    {"/joints/1",
     R"({"type": "gear", "between": ["crank", "rod"], "points": [[0, 0, 0], [0, 2, 0]], "axis": [0, 1, 0], )"
     R"("teeth": [20, 30]})",
     "/joints/1/points",
     {"joint 1 (crank - rod, gear)", "the centres of two wheels", "got two points on one axis"}},
    {"/joints/1",
     R"({"type": "gear", "between": ["crank", "rod"], "points": [[0, 0, 0], [2, 0, 0]], "axis": [0, 1, 0], )"
     R"("teeth": [20, 0]})",
     "/joints/1/teeth/1",
     {"expected a number of teeth from 1 to 1000", "got 0"}},
    {"/joints/1",
     R"({"type": "gear", "between": ["crank", "rod"], "points": [[0, 0, 0], [2, 0, 0]], )"
     R"("axes": [[0, 1, 0], [0, 0, 1]], "teeth": [20, 30]})",
     "/joints/1/axes",
     {"wheels about one direction", "90 degrees apart"}},
    {"/joints/1",
     R"({"type": "rack", "between": ["crank", "rod"], "points": [[0, 0, 0], [2, 0, 0]], )"
     R"("axes": [[1, 0, 0], [0, 1, 0]]})",
     "/joints/1/points",
     {"joint 1 (crank - rod, rack)", "pitch line of the rack", "got 0 m"}},
    {"/joints/1",
     R"({"type": "rack", "between": ["crank", "rod"], "points": [[0, 0, 1], [2, 0, 0]], )"
     R"("axes": [[1, 0, 0], [1, 1, 0]]})",
     "/joints/1/axes",
     {"perpendicular", "45 degrees"}},
    // point masses
    {"/joints/2/type", "\"fixed\"", "/joints/2/between/1", {"joint 2 (rod - bob, fixed)", "\"bob\" is a point mass"}},
    {"/joints/2/point", "[2, 0, 0.1]", "/joints/2/point", {"mass centre", "0.1 m away"}},
    {"/forces/0",
     R"({"type": "torque", "body": "bob", "value": [0, 0, 1]})",
     "/forces/0/body",
     {"force 0 (bob, torque)", "no torque can act"}},
    {"/forces/0",
     R"({"type": "force", "body": "bob", "value": [0, 0, 1], "point": [1, 0, 0]})",
     "/forces/0/point",
     {"mass centre"}},
    {"/forces/0",
     R"({"type": "torsion_spring", "between": ["rod", "bob"], "axis": [1, 0, 0], "stiffness": 1})",
     "/forces/0/between/1",
     {"\"bob\" is a point mass"}},
    {"/forces/0",
     R"({"type": "spring", "between": ["crank", "bob"], "points": [[0, 0, 1], [1, 0, 0]], "stiffness": 1})",
     "/forces/0/points/1",
     {"force 0 (crank - bob, spring)", "mass centre"}},
    // rolling
    {"/joints/1",
     R"({"type": "rolling", "between": ["crank", "rod"], "points": [[0, 0, -1], [1.5, 0, 0]], )"
     R"("axes": [[0, 0, 1], [0, 1, 0]], "radius": 1})",
     "/joints/1/between",
     {"expected \"ground\""}},
    {"/joints/1",
     R"({"type": "rolling", "between": ["rod", "ground"], "points": [[0, 0, -1], [1.5, 0, 0]], )"
     R"("axes": [[0, 0, 1], [0, 1, 0]], "radius": 1})",
     "/joints/1/between",
     {"and then the disk"}},
    {"/joints/1",
     R"({"type": "rolling", "between": ["ground", "rod"], "points": [[0, 0, -1], [1.5, 0, 0]], )"
     R"("axes": [[0, 0, 1], [0, 0, 1]], "radius": 1})",
     "/joints/1/axes",
     {"lie flat"}},
    {"/joints/1",
     R"({"type": "rolling", "between": ["ground", "rod"], "points": [[0, 0, -1], [1.5, 0, 0]], )"
     R"("axes": [[0, 0, 1], [0, 1, 0]], "radius": 0.5})",
     "",
     {"joint 1 (ground - rod, rolling): 0.5 m"}},
    // forces
    {"/forces/0",
     R"({"type": "spring", "between": ["crank", "rdo"], "points": [[0, 0, 1], [1, 0, 0]], "stiffness": 1})",
     "/forces/0/between/1",
     {"did you mean \"rod\"?"}},
    {"/forces/0",
     R"({"type": "spring", "between": ["rod", "rod"], "points": [[0, 0, 1], [1, 0, 0]], "stiffness": 1})",
     "/forces/0/between",
     {"force 0 (rod - rod, spring)", "two different bodies"}},
    {"/forces/0",
     R"({"type": "spring", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 0, 0]], "stiffness": 1, )"
     R"("length": 0.5})",
     "/forces/0/points",
     {"two different points"}},
    {"/forces/0",
     R"({"type": "spring", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 0, 0]], "stiffness": 1, )"
     R"("damping": 1})",
     "/forces/0/points",
     {"two different points"}},
    {"/forces/0",
     R"({"type": "torsion_spring", "between": ["crank", "rod"], "axis": [0, 0, 0], "stiffness": 1})",
     "/forces/0/axis",
     {"force 0 (crank - rod, torsion_spring)", "zero vector"}},
    {"/forces/0",
     R"({"type": "torque", "body": "ground", "value": [0, 0, 1]})",
     "/forces/0/body",
     {"a body that moves"}},
    {"/forces/0",
     R"({"type": "polynomial_spring", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 0, 0]], )"
     R"("coefficients": [1]})",
     "/forces/0/points",
     {"force 0 (crank - rod, polynomial_spring)", "two different points"}},
    {"/forces/0",
     R"({"type": "bushing", "between": ["crank", "rod"], "point": [1, 0, 0], "stiffness": [1, 1, 1], )"
     R"("torsional_stiffness": [1, 1, 1], "axes": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]})",
     "/forces/0/axes",
     {"rotation"}},
    {"/forces/0",
     R"({"type": "bushing", "between": ["rod", "bob"], "point": [2, 0, 0], "stiffness": [1, 1, 1], )"
     R"("torsional_stiffness": [1, 1, 1]})",
     "/forces/0/between/1",
     {"\"bob\" is a point mass"}},
    {"/forces/0",
     R"({"type": "gravitation", "between": ["ground", "rod"], "constant": 1})",
     "/forces/0/between",
     {"force 0 (ground - rod, gravitation)", "the ground has no mass"}},
    {"/forces/0",
     R"({"type": "central_field", "body": "rod", "mu": 1, "centre": [1.5, 0, 0]})",
     "/forces/0/centre",
     {"force 0 (rod, central_field)", "not the mass centre"}},
    {"/forces/0",
     R"({"type": "damper", "between": ["rod", "bob"], "point": [1, 0, 0], "damping": 1})",
     "/forces/0/point",
     {"force 0 (rod - bob, damper)", "mass centre"}},
    {"/forces/0",
     R"({"type": "force", "body": "carnk", "value": [0, 0, 1]})",
     "/forces/0/body",
     {"did you mean \"crank\"?"}},
    // velocities
    {"/bodies/0/v", "[1, 0, 0]", "", {"velocity level", "joint 0 (ground - crank, revolute): 1 m/s"}},
    {"/bodies/0/omega", "[0, 0, 2]", "", {"velocity level", "joint 0 (ground - crank, revolute)"}},
};

}  // namespace

TEST_CASE("each inadmissible mechanism is refused at its error", "[campaign]") {
    CHECK(refusal(changed({})) == "");
    CHECK(std::size(bad) >= 30);
    for (const Bad& one : bad) {
        const std::string message = refusal(changed({{one.place, one.value}}));
        INFO(one.place << " = " << one.value << "\n" << message);
        CHECK(message.find(": /problems/0/parameters" + one.pointer + ": ") != std::string::npos);
        for (const std::string& phrase : one.phrases) {
            INFO(phrase);
            CHECK(message.find(phrase) != std::string::npos);
        }
    }
}

TEST_CASE("every type of joint and of force makes a mechanism", "[campaign]") {
    const std::vector<std::pair<std::string, std::string>> accepted = {
        {"/joints/1",
         R"({"type": "revolute", "between": ["crank", "rod"], "point": [1, 0, 0], "axes": [[0, 2, 0], [0, -1, 0]]})"},
        {"/joints/1",
         R"({"type": "universal", "between": ["crank", "rod"], "point": [1, 0, 0], "axes": [[0, 2, 0], [0, 0, 1]]})"},
        {"/joints/1",
         R"({"type": "prismatic", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], "axis": [1, 0, 0]})"},
        {"/joints/1", R"({"type": "cylindrical", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], )"
                      R"("axis": [1, 0, 0]})"},
        {"/joints/1",
         R"({"type": "planar", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 3, 2]], "axis": [1, 0, 0]})"},
        {"/joints/1", R"({"type": "fixed", "between": ["crank", "rod"], "point": [1, 0, 0]})"},
        {"/joints/1",
         R"({"type": "distance", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 0, 2]], "length": 2})"},
        {"/joints/2",
         R"({"type": "distance", "between": ["bob", "rod"], "points": [[2, 0, 0], [1, 0, 2]], "amplitude": -0.5})"},
        {"/joints/1", R"({"type": "rolling", "between": ["ground", "rod"], "points": [[5, 0, -1], [1.5, 0, 0]], )"
                      R"("axes": [[0, 0, 1], [0, 1, 0]], "radius": 1})"},
        {"/joints/1", R"({"type": "distance", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], )"
                      R"("amplitude": 0.5, "frequency": 2})"},
        {"/joints/0/turn", R"({"polynomial": [0, 2, 1], "sinusoids": [{"amplitude": 0.1, "frequency": 20}]})"},
        {"/joints/1", R"({"type": "prismatic", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], )"
                      R"("axis": [1, 0, 0], "shift": {"polynomial": [0, 0, 0.1]}})"},
        {"/joints/1", R"({"type": "cylindrical", "between": ["crank", "rod"], "points": [[1, 0, 0], [2, 0, 0]], )"
                      R"("axes": [[1, 0, 0], [2, 0, 0]], "turn": {"polynomial": [0, 2]}, "shift": {"sinusoids": )"
                      R"([{"amplitude": 0.2, "frequency": 1, "phase": 0.5}, )"
                      R"({"amplitude": -0.2, "frequency": 2, "phase": 0.5}]}})"},
        {"/joints/1", R"({"type": "screw", "between": ["crank", "rod"], "points": [[1, 0, 0], [1.5, 0, 0]], )"
                      R"("axis": [1, 0, 0], "lead": -0.3})"},
        {"/joints/1", R"({"type": "gear", "between": ["crank", "rod"], "points": [[0, 0, 0], [1.5, 0, 0]], )"
                      R"("axis": [0, 1, 0], "teeth": [20, -30]})"},
        {"/joints/1", R"({"type": "rack", "between": ["rod", "crank"], "points": [[1.5, 0, 0.2], [0, 0, 0]], )"
                      R"("axes": [[1, 0, 0], [0, 1, 0]]})"},
        {"/joints", "[]"},
        {"/bodies/0/quaternion", "[0.6, 0.8, 0, 0]"},
        {"/forces/0",
         R"({"type": "spring", "between": ["ground", "bob"], "points": [[0, 0, 3], [2, 0, 0]], "stiffness": 3, )"
         R"("damping": 1, "length": 2})"},
        {"/forces/0",
         R"({"type": "spring", "between": ["crank", "rod"], "points": [[1, 0, 0], [1, 0, 0]], "stiffness": 3})"},
        {"/forces/0",
         R"({"type": "torsion_spring", "between": ["ground", "crank"], "axis": [0, 1, 0], "stiffness": 3, )"
         R"("angle": 0.5})"},
        {"/forces/0", R"({"type": "torque", "body": "rod", "value": [0, 0, 1], "frame": "body"})"},
        {"/forces/0",
         R"({"type": "force", "body": "bob", "value": [0, 0, 1], "point": [2, 0, 0], "amplitude": 1, "frequency": 2})"},
    };
    for (const auto& change : accepted) {
        INFO(change.first << " = " << change.second);
        const ordered_json parameters = changed({change});
        CHECK(refusal(parameters) == "");
        for (const PlannedCell& planned : plan_with(parameters).cells) {
            INFO(planned.cell().formulation << planned.skip_reason());
            CHECK(engine_binary64().run(planned.cell(), nullptr, {}).status == "ok");
        }
    }
}

TEST_CASE("a start that does not meet its joints is projected on demand, and that is said", "[campaign]") {
    const ordered_json apart = changed(
        {{"/joints/1", R"({"type": "spherical", "between": ["crank", "rod"], "points": [[1, 0, 0.01], [1, 0, 0]]})"},
         {"/project_initial", "true"}});
    const Plan plan = plan_with(apart);
    REQUIRE(plan.warnings.size() == 2);  // the other: a trajectory without samples
    CHECK(plan.warnings[0].find("project_initial moved bodies by up to 0.00") != std::string::npos);
    CHECK(plan_with(changed({{"/project_initial", "true"}})).warnings.size() == 1);

    const ordered_json crooked = changed(
        {{"/joints/1", R"({"type": "universal", "between": ["crank", "rod"], "point": [1, 0, 0], "axes": [[0, 1, 0], )"
                       R"([0, 0.1, 1]]})"},
         {"/project_initial", "true"}});
    CHECK(plan_with(crooked).warnings.size() == 2);
}

TEST_CASE("axes that nearly agree are brought together by turning little", "[campaign]") {
    const ordered_json tilted = changed({{"/joints/1",
                                          R"({"type": "prismatic", "between": ["crank", "rod"], "point": [1, 0, 0],
                                             "axes": [[1, 0.001, 0], [1, 0, 0.001]]})"},
                                         {"/project_initial", "true"}});
    const Plan plan = plan_with(tilted);
    REQUIRE(plan.warnings.size() == 2);
    const double turned = std::stod(plan.warnings[0].substr(plan.warnings[0].find(" m and ") + 7));
    CHECK(turned > 0.0003);
    CHECK(turned < 0.002);
}

TEST_CASE("velocities that are not given follow from the joints", "[campaign]") {
    const ordered_json turning = changed({{"/bodies/0/omega", "[0, 3, 0]"}});
    const Outcome outcome = engine_binary64().run(plan_with(turning).cells.at(0).cell(), nullptr, {});
    CHECK(outcome.status == "ok");
    CHECK(refusal(turning) == "");
}

TEST_CASE("velocities that contradict a prescribed coordinate are refused, by what was expected", "[campaign]") {
    const std::string message =
        refusal(changed({{"/joints/0/turn", R"({"polynomial": [0, 2]})"}, {"/bodies/0/omega", "[0, 3, 0]"}}));
    INFO(message);
    CHECK(message.find("velocity level") != std::string::npos);
    CHECK(
        message.find("joint 0 (ground - crank, revolute with driven turn): expected a turn of 2 rad/s, got 3 rad/s") !=
        std::string::npos);
    CHECK(refusal(changed({{"/joints/0/turn", R"({"polynomial": [0, 3]})"}, {"/bodies/0/omega", "[0, 3, 0]"}})) == "");
}

TEST_CASE("a start away from a prescribed coordinate is projected onto it, and that is said", "[campaign]") {
    const Plan plan =
        plan_with(changed({{"/joints/0/turn", R"({"polynomial": [0.3]})"}, {"/project_initial", "true"}}));
    REQUIRE(plan.warnings.size() == 2);
    CHECK(plan.warnings[0].find("project_initial moved bodies by up to") != std::string::npos);
}

TEST_CASE("the mechanism of the README is admissible", "[campaign]") {
    const std::string readme = text_of("README.md");
    const auto begin = readme.find("{\"name\": \"multibody\"");
    REQUIRE(begin != std::string::npos);
    const auto entry = ordered_json::parse(readme.substr(begin, readme.find("```", begin) - begin));
    CHECK(refusal(entry.at("parameters")) == "");
}

TEST_CASE("the shipped mechanism has every formulation and keeps to its joints", "[campaign]") {
    const Plan plan =
        plan_of(parse_document("multibody.json", text_of("experiments/mechanisms/multibody.json")), engines);
    CHECK(plan.skipped() == 0);
    CHECK(plan.warnings.empty());
    for (const PlannedSystems::Shared& system : plan.systems.kinds()) {
        CHECK(system->bodies == 4);
        CHECK(system->constraints.rows == 18);
    }
}

TEST_CASE("redundant rows on a base that turns are chosen anew as it does", "[campaign]") {
    // A lead screw of 0.05 m in a turn moves a slide on a turntable, on which each has a joint of its own.
    const Plan plan = plan_with(ordered_json::parse(R"({
        "gravity": [0, 0, 0],
        "bodies": [{"name": "table", "mass": 5, "inertia": [0.5, 0.5, 1], "x": [0, 0, 0]},
                   {"name": "spindle", "mass": 1, "inertia": [0.002, 0.01, 0.01], "x": [0.5, 0, 0.1]},
                   {"name": "slide", "mass": 2, "inertia": [0.02, 0.02, 0.02], "x": [0.3, 0.1, 0.1]}],
        "joints": [{"type": "revolute", "between": ["ground", "table"], "point": [0, 0, 0], "axis": [0, 0, 1],
                    "turn": {"polynomial": [0, 3]}},
                   {"type": "revolute", "between": ["table", "spindle"], "point": [0.5, 0, 0.1], "axis": [1, 0, 0],
                    "turn": {"polynomial": [0, 20]}},
                   {"type": "prismatic", "between": ["table", "slide"], "point": [0.3, 0.1, 0.1], "axis": [1, 0, 0]},
                   {"type": "screw", "between": ["spindle", "slide"], "point": [0.3, 0, 0.1], "axis": [1, 0, 0],
                    "lead": 0.05}]})"));
    REQUIRE(plan.cells.size() == 3);
    const double place = 0.3 - 0.05 * 20 / 6.283185307179586;  // along the table after 1 s
    for (const PlannedCell& planned : plan.cells) {
        Cell cell = planned.cell();
        cell.steps = 1000;
        INFO(cell.formulation);
        const Outcome outcome = engine_binary64().run(cell, nullptr, {});
        REQUIRE(outcome.status == "ok");
        const ReportedBody& slide = outcome.final->bodies.at(2);
        CHECK(std::abs(slide.x[0].value - (std::cos(3.0) * place - std::sin(3.0) * 0.1)) < 1e-5);
        CHECK(std::abs(slide.x[1].value - (std::sin(3.0) * place + std::cos(3.0) * 0.1)) < 1e-5);
    }
}
