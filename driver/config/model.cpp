// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "driver/config/catalogue.hpp"
#include "driver/config/values.hpp"
#include "records/json/model_keys.hpp"

namespace kreisel {

namespace {

constexpr std::size_t longest_name = 64;

template <class Value>
void assign(Value& target, const std::optional<Value>& value) {
    if (value) { target = *value; }
}

// The value of a key, if it is there and fits.
std::optional<Vector3> vector_at(const Node& entry, const std::string& key) {
    const auto node = entry.find(key);
    return node ? read_vector(*node, expectation(ValueKind::vector)) : std::nullopt;
}

std::optional<double> number_at(const Node& entry, const std::string& key) {
    const auto node = entry.find(key);
    return node ? node->number() : std::nullopt;
}

std::optional<double> positive_at(const Node& entry, const std::string& key, const std::string& unit) {
    const auto node = entry.find(key);
    return node ? node->positive(fmt::format("a {} greater than 0 ({})", key, unit)) : std::nullopt;
}

std::optional<double> not_negative_at(const Node& entry, const std::string& key) {
    const auto node = entry.find(key);
    if (!node) { return std::nullopt; }
    const std::string expected = expectation(ValueKind::not_negative);
    const auto value = node->number(expected);
    if (value && !(*value >= 0)) {
        node->mismatch(expected);
        return std::nullopt;
    }
    return value;
}

std::optional<std::string> name_at(const Node& entry, const std::string& key) {
    const auto node = entry.find(key);
    return node ? node->text(expectation(ValueKind::name), longest_name) : std::nullopt;
}

// A list of two values, one for each body, read one by one.
template <class Value, class Read>
void read_pair(const Node& entry, const std::string& key, ValueKind kind, std::array<Value, 2>& target,
               const Read& read) {
    const auto node = entry.find(key);
    if (!node) { return; }
    if (!node->is_array() || node->json().size() != 2) { return node->mismatch(expectation(kind)); }
    const auto values = node->elements_or_self();
    for (std::size_t i = 0; i < 2; ++i) { assign(target[i], read(values[i])); }
}

void read_between(const Node& entry, std::array<std::string, 2>& between) {
    read_pair(entry, "between", ValueKind::names, between,
              [](const Node& node) { return node.text(expectation(ValueKind::name), longest_name); });
}

void read_vectors(const Node& entry, const std::string& one, const std::string& each, std::array<Vector3, 2>& values) {
    if (const auto shared = vector_at(entry, one)) { values = {*shared, *shared}; }
    read_pair(entry, each, ValueKind::vectors, values,
              [](const Node& node) { return read_vector(node, expectation(ValueKind::vector)); });
}

// R of a quaternion, which is normalised first.
std::optional<Matrix3> read_quaternion(const Node& node, const PrintedNumbers& printed) {
    const std::string expected = expectation(ValueKind::quaternion);
    if (!node.is_array() || node.json().size() != 4) {
        node.mismatch(expected);
        return std::nullopt;
    }
    std::array<double, 4> q{};
    bool good = true;
    const auto components = node.elements_or_self();
    for (std::size_t i = 0; i < 4; ++i) {
        const auto number = components[i].number();
        good = good && number;
        q[i] = number.value_or(0);
    }
    if (!good) { return std::nullopt; }
    const auto unit = printed.quaternion(node, q);
    if (!unit) { return std::nullopt; }
    const auto [w, x, y, z] = *unit;
    return Matrix3{1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                   2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                   2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
}

std::optional<std::string> read_body_name(const Node& entry) {
    const auto name = name_at(entry, "name");
    const bool plain =
        name && std::all_of(name->begin(), name->end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
        });
    if (name && (!plain || *name == "ground")) {
        entry.find("name")->mismatch("a name of letters, digits, _ and - other than \"ground\"");
        return std::nullopt;
    }
    return name;
}

BodyData read_body(const Node& node, const ElementType& type, const PrintedNumbers& printed) {
    BodyData body;
    body.point = type.name == "point";
    assign(body.name, read_body_name(node));
    assign(body.mass, positive_at(node, "mass", "kg"));
    assign(body.x, vector_at(node, "x"));
    body.v = vector_at(node, "v");
    if (body.point) { return body; }
    if (const auto inertia = node.find("inertia")) { assign(body.inertia, read_inertia(*inertia, printed)); }
    if (const auto R = node.find("R")) { assign(body.R, read_rotation(*R, printed)); }
    if (const auto quaternion = node.find("quaternion")) { assign(body.R, read_quaternion(*quaternion, printed)); }
    // What was computed of the text; -0 would be read again as 0.
    for (Matrix3* matrix : {&body.R, &body.inertia}) {
        for (double& entry : *matrix) { entry += 0.0; }
    }
    body.omega = vector_at(node, "omega");
    return body;
}

SinusoidData read_sinusoid(const Node& node) {
    SinusoidData sinusoid;
    if (!node.require_object("a sinusoid: an object")) { return sinusoid; }
    node.only_keys({"amplitude", "frequency", "phase"}, " of a sinusoid");
    node.require("amplitude", "a number, the unit that of the coordinate");
    node.require("frequency", "a number (rad/s)");
    assign(sinusoid.amplitude, number_at(node, "amplitude"));
    assign(sinusoid.frequency, number_at(node, "frequency"));
    assign(sinusoid.phase, number_at(node, "phase"));
    return sinusoid;
}

// The elements of a list that is not empty; none after an error.
std::vector<Node> elements_at(const Node& entry, const std::string& key, const std::string& expected) {
    const auto list = entry.find(key);
    if (!list) { return {}; }
    if (!list->is_array() || list->json().empty()) {
        list->mismatch(expected);
        return {};
    }
    return list->elements_or_self();
}

std::optional<MotionData> motion_at(const Node& entry, const std::string& key) {
    const auto node = entry.find(key);
    if (!node || !node->require_object(expectation(ValueKind::motion))) { return std::nullopt; }
    node->only_keys({"polynomial", "sinusoids"}, " of a " + key);
    if (!node->find("polynomial") && !node->find("sinusoids")) { node->mismatch(expectation(ValueKind::motion)); }
    MotionData motion;
    for (const Node& one : elements_at(*node, "polynomial", expectation(ValueKind::numbers))) {
        motion.polynomial.push_back(one.number().value_or(0));
    }
    for (const Node& one : elements_at(*node, "sinusoids", "a list of sinusoids, at least one")) {
        motion.sinusoids.push_back(read_sinusoid(one));
    }
    return motion;
}

JointData read_joint(const Node& node, const ElementType& type, const PrintedNumbers& /*printed*/) {
    JointData joint;
    joint.type = type.name;
    if (const auto name = node.find("name")) {
        assign(joint.name, name->text(expectation(ValueKind::label), longest_name));
    }
    read_between(node, joint.between);
    read_vectors(node, "point", "points", joint.points);
    if (type.has("axes")) { read_vectors(node, "axis", "axes", joint.axes); }
    joint.length = positive_at(node, type.has("radius") ? "radius" : "length", "m");
    assign(joint.amplitude, number_at(node, "amplitude"));
    assign(joint.frequency, number_at(node, "frequency"));
    joint.turn = motion_at(node, "turn");
    joint.shift = motion_at(node, "shift");
    joint.lead = number_at(node, "lead");
    read_pair(node, "teeth", ValueKind::teeth, joint.teeth,
              [](const Node& one) { return one.count(-largest_whole, largest_whole, "a number of teeth"); });
    return joint;
}

std::optional<Vector3> not_negatives_at(const Node& entry, const std::string& key) {
    const auto node = entry.find(key);
    if (!node) { return std::nullopt; }
    const std::string expected = expectation(ValueKind::not_negatives);
    const auto values = read_vector(*node, expected);
    if (values && std::any_of(values->begin(), values->end(), [](double value) { return !(value >= 0); })) {
        node->mismatch(expected);
        return std::nullopt;
    }
    return values;
}

void read_bushing(const Node& node, const PrintedNumbers& printed, ForceData& force) {
    if (const auto axes = node.find("axes")) { assign(force.axes, read_rotation(*axes, printed)); }
    assign(force.stiffnesses[0], not_negatives_at(node, "stiffness"));
    assign(force.stiffnesses[1], not_negatives_at(node, "torsional_stiffness"));
    assign(force.dampings[0], not_negatives_at(node, "damping"));
    assign(force.dampings[1], not_negatives_at(node, "torsional_damping"));
}

std::vector<double> read_coefficients(const Node& node) {
    std::vector<double> coefficients;
    for (const Node& one : elements_at(node, "coefficients", expectation(ValueKind::numbers))) {
        coefficients.push_back(one.number().value_or(0));
    }
    return coefficients;
}

// A given force or torque, or the centre of a field.
void read_on_one_body(const Node& node, const ElementType& type, ForceData& force) {
    assign(force.between[1], name_at(node, "body"));
    assign(force.value, vector_at(node, "value"));
    force.point = vector_at(node, type.has("centre") ? "centre" : "point");
    if (const auto frame = node.find("frame")) {
        force.body_axes = frame->name(expectation(ValueKind::frame), {"space", "body"}) == "body";
    }
}

void read_between_bodies(const Node& node, const ElementType& type, ForceData& force) {
    read_between(node, force.between);
    if (type.has("points")) {
        read_vectors(node, "point", "points", force.points);
    } else {
        force.point = vector_at(node, "point");
    }
}

ForceData read_force(const Node& node, const ElementType& type, const PrintedNumbers& printed) {
    ForceData force;
    force.type = type.name;
    (type.has("body") ? read_on_one_body : read_between_bodies)(node, type, force);
    assign(force.axis, vector_at(node, "axis"));
    if (type.has("torsional_stiffness")) {
        read_bushing(node, printed, force);
    } else {
        assign(force.stiffness, not_negative_at(node, "stiffness"));
        assign(force.damping, not_negative_at(node, "damping"));
    }
    force.coefficients = read_coefficients(node);
    assign(force.attraction, not_negative_at(node, type.has("mu") ? "mu" : "constant"));
    force.rest = type.has("angle") ? number_at(node, "angle") : not_negative_at(node, "length");
    if (const auto turns = node.find("turns")) {
        assign(force.turns, turns->count(-largest_whole, largest_whole, expectation(ValueKind::whole)));
    }
    assign(force.amplitude, number_at(node, "amplitude"));
    assign(force.frequency, number_at(node, "frequency"));
    return force;
}

// Unknown keys, missing keys, and pairs of keys that exclude each other.
void check_keys(const Node& node, const ElementList& list, const ElementType& type) {
    node.only_keys(keys_of(type), fmt::format(" of a {} of type {}", list.what, in_quotes(type.name)));
    for (const ElementKey& key : type.keys) {
        if (key.required) { node.require(key.name, expectation(key.kind)); }
    }
    for (const auto& [one, other, required] : type.alternatives) {
        const bool both = node.find(one) && node.find(other), none = !node.find(one) && !node.find(other);
        if (both) { node.error(fmt::format("either {} or {}", in_quotes(one), in_quotes(other)), "both"); }
        if (none && required) {
            node.error(fmt::format("the key {} or {}", in_quotes(one), in_quotes(other)), "nothing");
        }
    }
}

// Null after an error.
const ElementType* read_type(const Node& node, const ElementList& list) {
    const std::string what = fmt::format("a type of {}", list.what);
    std::optional<std::string> name = list.standard;
    if (node.find("type")) {
        name = node.find("type")->name(what, names_of(list.types));
    } else if (name->empty()) {
        name.reset();
        node.require("type", fmt::format("{} ({})", what, listed(names_of(list.types))));
    }
    return name ? find_named(list.types, *name) : nullptr;
}

template <class Data>
std::optional<ParameterValue> read_list(const Node& node, ParameterKind kind, std::size_t least,
                                        const PrintedNumbers& printed,
                                        Data (*read)(const Node&, const ElementType&, const PrintedNumbers&)) {
    const ElementList& list = elements_of(kind);
    if (!node.is_array() || node.json().size() < least) {
        node.mismatch(expectation(kind));
        return std::nullopt;
    }
    std::vector<Data> all;
    for (const Node& entry : node.elements_or_self()) {
        all.emplace_back();
        if (!entry.require_object(fmt::format("a {}: an object", list.what))) { continue; }
        const ElementType* type = read_type(entry, list);
        if (!type) { continue; }
        check_keys(entry, list, *type);
        all.back() = read(entry, *type, printed);
    }
    return all;
}

template <class Data>
void check_names(const Node& node, const std::vector<Data>& named, const std::string& what) {
    std::set<std::string> names;
    const auto entries = node.elements_or_self();
    for (std::size_t i = 0; i < named.size(); ++i) {
        if (!named[i].name.empty() && !names.insert(named[i].name).second) {
            entries[i].violates(Rule::own_name, what + " with different names", "a second " + in_quotes(named[i].name));
        }
    }
}

}  // namespace

std::optional<ParameterValue> parse_bodies(const Node& node, const PrintedNumbers& printed) {
    auto bodies = read_list(node, ParameterKind::bodies, 1, printed, read_body);
    if (bodies) { check_names(node, std::get<std::vector<BodyData>>(*bodies), "bodies"); }
    return bodies;
}

std::optional<ParameterValue> parse_joints(const Node& node) {
    auto joints = read_list(node, ParameterKind::joints, 0, PrintedNumbers(), read_joint);
    if (joints) { check_names(node, std::get<std::vector<JointData>>(*joints), "joints"); }
    return joints;
}

std::optional<ParameterValue> parse_forces(const Node& node, const PrintedNumbers& printed) {
    return read_list(node, ParameterKind::forces, 0, printed, read_force);
}

}  // namespace kreisel
