// SPDX-License-Identifier: BSD-3-Clause
//
// Mechanisms that are well-formed but inadmissible: each is refused at its error, naming joint and bodies.
#include <catch2/catch.hpp>
#include <iterator>

#include "tests/campaign/mechanisms/chain.hpp"

namespace kreisel::mechanism_tests {

namespace {

struct Bad {
    std::string place, value;  ///< what is put into the chain
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

}  // namespace kreisel::mechanism_tests
