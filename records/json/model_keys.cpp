// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/model_keys.hpp"

#include <map>
#include <stdexcept>

#include "mechanics/parts/force_type.hpp"
#include "mechanics/parts/joint_type.hpp"
#include "records/json/model.hpp"

namespace kreisel {

namespace {

using Kind = ValueKind;

ElementList bodies() {
    const ElementKey name = {"name", Kind::name, true}, mass = {"mass", Kind::positive, true},
                     x = {"x", Kind::vector, true}, v = {"v", Kind::vector, false};
    return {"body",
            "rigid",
            {{"rigid",
              "rigid body",
              {name,
               mass,
               {"inertia", Kind::inertia, true},
               x,
               {"R", Kind::matrix, false},
               {"quaternion", Kind::quaternion, false},
               v,
               {"omega", Kind::vector, false}},
              {{"R", "quaternion", false}}},
             {"point", "point mass, held only by " + joints_that_hold_points() + " joints", {name, mass, x, v}}}};
}

ElementList joints() {
    ElementList list = {"joint", "", {}};
    for (const JointKind& kind : joint_kinds()) { list.types.push_back(kind.element); }
    return list;
}

ElementList forces() {
    ElementList list = {"force", "", {}};
    for (const ForceKind& kind : force_kinds()) { list.types.push_back(kind); }
    return list;
}

}  // namespace

bool has_elements(ParameterKind kind) {
    return kind == ParameterKind::bodies || kind == ParameterKind::joints || kind == ParameterKind::forces;
}

const ElementList& elements_of(ParameterKind kind) {
    static const ElementList all_bodies = bodies(), all_joints = joints(), all_forces = forces();
    switch (kind) {
        case ParameterKind::bodies:
            return all_bodies;
        case ParameterKind::joints:
            return all_joints;
        case ParameterKind::forces:
            return all_forces;
        default:
            throw std::logic_error("a parameter of this kind has no entries");
    }
}

std::string meaning_of_key(const std::string& key) {
    static const std::map<std::string, std::string> all = {
        {"name",
         "letters, digits, _ and -; joints and forces call a body by it, results a joint (default: its bodies)"},
        {"mass", "kg"},
        {"inertia", "about the mass centre, body axes, kg m^2; three numbers or a symmetric matrix"},
        {"x", "initial mass centre, space axes, m"},
        {"R", "initial rotation, body to space (default: none)"},
        {"quaternion", "[w, x, y, z] of norm 1, in place of R"},
        {"v", "initial velocity, space axes, m/s (default: from the joints and what is given)"},
        {"omega", "initial angular velocity, body axes, rad/s (default: from the joints and what is given)"},
        {"between", "the names of two bodies, or \"ground\" and one"},
        {"point", "space coordinates of the initial configuration, m; of a force by default the mass centre"},
        {"points", "one for each body, where they differ or the start is to be projected"},
        {"axis", "direction in space coordinates of the initial configuration; of a planar joint the normal"},
        {"axes",
         "one for each body; of a bushing the matrix whose columns are its axes at the start (default: space axes)"},
        {"length", "m (default: the initial one)"},
        {"radius", "m"},
        {"teeth", "[z_1, z_2], of the first wheel and of the second; below 0 of a ring with its teeth inside"},
        {"lead", "shift in one turn, m: not 0, below 0 for a left-handed thread"},
        {"turn",
         "prescribed turn of the second body about its axis, rad: {\"polynomial\": [c_0, c_1, ...], \"sinusoids\": "
         "[{\"amplitude\": A, \"frequency\": W, \"phase\": p}, ...]} for c_0 + c_1 t + ... + A sin(W t + p) + ..., "
         "from the configuration as given (default: free)"},
        {"shift", "prescribed shift of the second body along its axis, m, written like a turn (default: free)"},
        {"angle", "at which the spring is free, rad: any number, since full turns count (default: 0)"},
        {"coefficients", "c_1, c_2, ... in N/m, N/m^2, ..."},
        {"constant", "of gravitation, m^3/(kg s^2)"},
        {"mu", "constant of gravitation times the mass at the centre, m^3/s^2"},
        {"centre", "space axes, m (default: the origin)"},
        {"torsional_stiffness", "about the axes of the bushing, N m/rad"},
        {"torsional_damping", "about the axes of the bushing, N m s/rad (default: 0)"},
        {"turns", "full turns that the spring has made at the start, a whole number (default: 0)"},
        {"amplitude", "default: 0"},
        {"frequency", "rad/s (default: 0)"},
        {"stiffness", "N/m, of a torsion spring N m/rad; of a bushing three numbers, along its axes"},
        {"damping", "N s/m, about axes N m s/rad; of a bushing three numbers (default: 0)"},
        {"body", "the name of a body"},
        {"value", "three components, N or N m"},
        {"frame", "axes of the value: \"space\" (default) or \"body\", which turn with the body"}};
    return all.at(key);
}

std::string expectation(ValueKind kind) {
    switch (kind) {
        case Kind::name:
            return "the name of a body";
        case Kind::label:
            return "a name of letters, digits, _ and -";
        case Kind::names:
            return "a list of two bodies: names, or \"ground\" and a name";
        case Kind::number:
            return "a number";
        case Kind::whole:
            return "full turns";
        case Kind::positive:
            return "a number greater than 0";
        case Kind::not_negative:
            return "a number of at least 0";
        case Kind::numbers:
            return "a list of numbers, at least one";
        case Kind::vector:
            return "three numbers";
        case Kind::not_negatives:
            return "three numbers of at least 0";
        case Kind::vectors:
            return "a list of two, one for each body: three numbers each";
        case Kind::matrix:
            return "a rotation matrix: three rows of three numbers";
        case Kind::quaternion:
            return "a unit quaternion: four numbers w, x, y, z";
        case Kind::inertia:
            return "an inertia: three numbers, or a symmetric matrix of three rows of three numbers";
        case Kind::frame:
            return "the axes of the value";
        case Kind::teeth:
            return "a list of two whole numbers";
        case Kind::motion:
            return "a function of time: an object with \"polynomial\", \"sinusoids\" or both";
    }
    return "";
}

std::vector<std::string> keys_of(const ElementType& type) {
    std::vector<std::string> keys = {"type"};
    for (const ElementKey& key : type.keys) { keys.push_back(key.name); }
    if (may_have_shape(type)) { keys.emplace_back(shape_key); }
    return keys;
}

}  // namespace kreisel
