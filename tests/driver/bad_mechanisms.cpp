// SPDX-License-Identifier: BSD-3-Clause
//
// Mechanisms that are written wrongly: what the reader alone can tell. Each line changes one value of a good mechanism.
#include "tests/driver/bad_mechanisms.hpp"

namespace kreisel {

std::string good_mechanism() {
    return R"({"bodies": [{"name": "crank", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [0.5, 0, 0]},
                          {"name": "rod", "mass": 1, "inertia": [0.1, 0.1, 0.1], "x": [1.5, 0, 0]},
                          {"type": "point", "name": "bob", "mass": 1, "x": [2, 0, 0]}],
               "joints": [{"type": "spherical", "between": ["ground", "crank"], "point": [0, 0, 0]},
                          {"type": "revolute", "between": ["crank", "rod"], "point": [1, 0, 0], "axis": [0, 0, 1]},
                          {"type": "distance", "between": ["rod", "bob"], "points": [[2, 0, 1], [2, 0, 0]]}],
               "forces": [{"type": "spring", "between": ["ground", "rod"], "points": [[1, 0, 1], [1.5, 0, 0]], "stiffness": 10},
                          {"type": "torque", "body": "rod", "value": [0, 0, 1]},
                          {"type": "torsion_spring", "between": ["crank", "rod"], "axis": [0, 0, 1], "stiffness": 1}]})";
}

const std::vector<BadMechanism>& bad_mechanisms() {
    static const std::vector<BadMechanism> all = {
        // lists
        {"/bodies", "[]", "/bodies", "a list of bodies, at least one"},
        {"/bodies", "{}", "/bodies", "a list of bodies"},
        {"/joints", "{}", "/joints", "a list of joints"},
        {"/joints", "null", "/joints", "got null"},
        {"/forces", "\"none\"", "/forces", "a list of forces"},
        {"/forces/0", "[]", "/forces/0", "a force: an object"},
        {"/joints/0", "\"spherical\"", "/joints/0", "a joint: an object"},
        {"/bodies/0", "3", "/bodies/0", "a body: an object"},
        {"/project_initial", "1", "/project_initial", "true or false"},
        {"/project_initail", "true", "/project_initail", "did you mean \"project_initial\"?"},
        // bodies
        {"/bodies/0/type", "\"piont\"", "/bodies/0/type", "did you mean \"point\"?"},
        {"/bodies/0/type", "1", "/bodies/0/type", "a type of body (\"rigid\", \"point\")"},
        {"/bodies/0/type", "\"point\"", "/bodies/0/inertia",
         "of a body of type \"point\" \"type\", \"name\", \"mass\""},
        {"/bodies/2/omega", "[0, 0, 1]", "/bodies/2/omega", "of a body of type \"point\""},
        {"/bodies/2/R", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]", "/bodies/2/R", "of a body of type \"point\""},
        {"/bodies/0/name", "\"rod\"", "/bodies/1", "a second \"rod\""},
        {"/bodies/0/name", "\"\"", "/bodies/0/name", "got 0 bytes"},
        {"/bodies/0/name", "7", "/bodies/0/name", "the name of a body"},
        {"/bodies/0/mass", "0", "/bodies/0/mass", "a mass greater than 0 (kg)"},
        {"/bodies/2/mass", "\"1\"", "/bodies/2/mass", "got \"1\""},
        {"/bodies/0/x", "[0, 0]", "/bodies/0/x", "three numbers"},
        {"/bodies/0/v", "0", "/bodies/0/v", "three numbers"},
        {"/bodies/0/inertia", "[[1, 0, 0], [0, 1, 0], [0, 1, 1]]", "/bodies/0/inertia", "not symmetric"},
        {"/bodies/0/R", "[1, 0, 0]", "/bodies/0/R/0", "a rotation matrix"},
        {"/bodies/0/quaternion", "[1, 0, 0]", "/bodies/0/quaternion", "four numbers w, x, y, z"},
        {"/bodies/0/quaternion", "[1, 0, 0, 0.01]", "/bodies/0/quaternion", "norm 1 within 1e-9"},
        {"/bodies/0/quaternion", "[0, 0, 0, 0]", "/bodies/0/quaternion", "got norm 0"},
        {"/bodies/0/quaternion", "[1, 0, 0, \"0\"]", "/bodies/0/quaternion/3", "a number"},
        {"/bodies/0/spin", "1", "/bodies/0/spin", "got the key \"spin\""},
        {"/bodies/0/quaternoin", "[1, 0, 0, 0]", "/bodies/0/quaternoin", "did you mean \"quaternion\"?"},
        // joints
        {"/joints/0/type", "\"sphercial\"", "/joints/0/type", "did you mean \"spherical\"?"},
        {"/joints/0/type", "\"weld\"", "/joints/0/type", "\"fixed\""},
        {"/joints/0/type", "null", "/joints/0/type", "got null"},
        {"/joints/0", R"({"between": ["ground", "crank"], "point": [0, 0, 0]})", "/joints/0", "the key \"type\""},
        {"/joints/0", R"({"type": "fixed", "point": [0, 0, 0]})", "/joints/0", "the key \"between\""},
        {"/joints/0", R"({"type": "fixed", "between": ["ground", "crank"]})", "/joints/0",
         "the key \"point\" or \"points\""},
        {"/joints/0/points", "[[0, 0, 0], [0, 0, 0]]", "/joints/0", "either \"point\" or \"points\", got both"},
        {"/joints/0/axis", "[0, 0, 1]", "/joints/0/axis",
         "of a joint of type \"spherical\" \"type\", \"between\", \"point\""},
        {"/joints/0/between", "[\"ground\"]", "/joints/0/between", "a list of two bodies"},
        {"/joints/0/between", "[\"ground\", \"crank\", \"rod\"]", "/joints/0/between", "a list of two bodies"},
        {"/joints/0/between", "\"ground\"", "/joints/0/between", "\"ground\" and a name"},
        {"/joints/0/between/1", "1", "/joints/0/between/1", "the name of a body"},
        {"/joints/0/point", "0", "/joints/0/point", "three numbers"},
        {"/joints/1/axis", "\"z\"", "/joints/1/axis", "three numbers"},
        {"/joints/1/axes", "[[0, 0, 1], [0, 0, 1]]", "/joints/1", "either \"axis\" or \"axes\""},
        {"/joints/1", R"({"type": "revolute", "between": ["crank", "rod"], "point": [1, 0, 0]})", "/joints/1",
         "the key \"axis\" or \"axes\""},
        {"/joints/1", R"({"type": "universal", "between": ["crank", "rod"], "point": [1, 0, 0]})", "/joints/1",
         "the key \"axes\": a list of two, one for each body"},
        {"/joints/1/type", "\"universal\"", "/joints/1/axis", "of a joint of type \"universal\""},
        {"/joints/1/length", "1", "/joints/1/length", "of a joint of type \"revolute\""},
        {"/joints/2/points", "[[2, 0, 1]]", "/joints/2/points", "a list of two, one for each body"},
        {"/joints/2/points/0", "[2, 0]", "/joints/2/points/0", "three numbers"},
        {"/joints/2/length", "0", "/joints/2/length", "a length greater than 0 (m)"},
        {"/joints/2/length", "-1", "/joints/2/length", "got -1"},
        {"/joints/2/amplitude", "[0.1]", "/joints/2/amplitude", "a number"},
        {"/joints/2/radius", "1", "/joints/2/radius", "of a joint of type \"distance\""},
        {"/joints/2/type", "\"rolling\"", "/joints/2", "the key \"axes\""},
        {"/joints/2",
         R"({"type": "rolling", "between": ["ground", "rod"], "points": [[0, 0, 0], [0, 0, 1]], "axes": [[0, 0, 1], [1, 0, 0]]})",
         "/joints/2", "the key \"radius\": a number greater than 0"},
        // forces
        {"/forces/0/type", "\"sprign\"", "/forces/0/type", "did you mean \"spring\"?"},
        {"/forces/0/type", "\"motor\"", "/forces/0/type", "a type of force"},
        {"/forces/0/stiffness", "-1", "/forces/0/stiffness", "a number of at least 0"},
        {"/forces/0/damping", "-0.1", "/forces/0/damping", "got -0.1"},
        {"/forces/0/length", "-1", "/forces/0/length", "at least 0"},
        {"/forces/0/stifness", "1", "/forces/0/stifness", "did you mean \"stiffness\"?"},
        {"/forces/0", R"({"type": "spring", "between": ["ground", "rod"], "points": [[1, 0, 1], [1.5, 0, 0]]})",
         "/forces/0", "the key \"stiffness\": a number of at least 0"},
        {"/forces/0/axis", "[0, 0, 1]", "/forces/0/axis", "of a force of type \"spring\""},
        {"/forces/0/point", "[0, 0, 1]", "/forces/0/point", "of a force of type \"spring\""},
        {"/forces/1/frame", "\"bdoy\"", "/forces/1/frame", "did you mean \"body\"?"},
        {"/forces/1/frame", "\"inertial\"", "/forces/1/frame", "(\"space\", \"body\")"},
        {"/forces/1/value", "1", "/forces/1/value", "three numbers"},
        {"/forces/1/point", "[1, 0, 0]", "/forces/1/point", "of a force of type \"torque\""},
        {"/forces/1/between", "[\"ground\", \"rod\"]", "/forces/1/between", "\"body\""},
        {"/forces/1/body", "[\"rod\"]", "/forces/1/body", "the name of a body"},
        {"/forces/2/axis", "[1, 0]", "/forces/2/axis", "three numbers"},
        {"/forces/2/angle", "\"pi\"", "/forces/2/angle", "a number"},
        {"/forces/2/length", "1", "/forces/2/length", "of a force of type \"torsion_spring\""},
    };
    return all;
}

}  // namespace kreisel
