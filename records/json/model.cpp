// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/model.hpp"

#include <stdexcept>

#include "mechanics/parts/force_type.hpp"
#include "mechanics/parts/joint_type.hpp"
#include "records/json/lists.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

std::string json_vector(const Vector3& v) { return json_list(v, json_number); }

std::string json_sinusoid(const SinusoidData& sinusoid) {
    ObjectWriter object;
    object.member("amplitude", json_number(sinusoid.amplitude)).member("frequency", json_number(sinusoid.frequency));
    return object.member("phase", json_number(sinusoid.phase)).text();
}

std::string json_motion(const MotionData& motion) {
    ObjectWriter object;
    if (!motion.polynomial.empty()) { object.member("polynomial", json_list(motion.polynomial, json_number)); }
    if (!motion.sinusoids.empty()) { object.member("sinusoids", json_list(motion.sinusoids, json_sinusoid)); }
    return object.text();
}

std::string body_with_shape(const BodyData& body, const Shapes& shapes) {
    std::string text = json_element(body);
    const auto shape = shapes.find(body.name);
    if (body.point || shape == shapes.end()) { return text; }
    text.pop_back();
    return text + "," + json_text(shape_key) + ":" + json_shape(shape->second) + "}";
}

Vector3 three_numbers(const JsonValue& json) {
    if (json.elements.size() != 3) { throw std::invalid_argument("expected three numbers"); }
    return {json.elements[0].number(), json.elements[1].number(), json.elements[2].number()};
}

}  // namespace

std::string json_element(const BodyData& body) {
    ObjectWriter object;
    if (body.point) { object.member("type", json_text("point")); }
    object.member("name", json_text(body.name)).member("mass", json_number(body.mass));
    if (!body.point) { object.member("inertia", json_rows(body.inertia, json_number)); }
    object.member("x", json_vector(body.x));
    if (!body.point) { object.member("R", json_rows(body.R, json_number)); }
    if (body.v) { object.member("v", json_vector(*body.v)); }
    if (!body.point && body.omega) { object.member("omega", json_vector(*body.omega)); }
    return object.text();
}

std::string json_element(const JointData& joint) {
    const ElementType& type = JointType(joint.type)->element;
    ObjectWriter object;
    object.member("type", json_text(type.name));
    if (!joint.name.empty()) { object.member("name", json_text(joint.name)); }
    object.member("between", json_list(joint.between, json_text));
    object.member("points", json_list(joint.points, json_vector));
    if (type.has("axes")) { object.member("axes", json_list(joint.axes, json_vector)); }
    if (joint.length) { object.member(type.has("radius") ? "radius" : "length", json_number(*joint.length)); }
    if (type.has("amplitude")) {
        object.member("amplitude", json_number(joint.amplitude)).member("frequency", json_number(joint.frequency));
    }
    if (joint.turn) { object.member("turn", json_motion(*joint.turn)); }
    if (joint.shift) { object.member("shift", json_motion(*joint.shift)); }
    if (type.has("teeth")) {
        object.member("teeth", json_list(joint.teeth, [](long teeth) { return std::to_string(teeth); }));
    }
    if (joint.lead) { object.member("lead", json_number(*joint.lead)); }
    return object.text();
}

std::string json_element(const ForceData& force) {
    const ElementType& type = force_kind(force.type);
    ObjectWriter object;
    const auto write = [&](const char* key, const std::string& value) {
        if (type.has(key)) { object.member(key, value); }
    };
    object.member("type", json_text(type.name));
    write("body", json_text(force.between[1]));
    write("between", json_list(force.between, json_text));
    write("value", json_vector(force.value));
    write("frame", json_text(force.body_axes ? "body" : "space"));
    if (force.point) {
        write("point", json_vector(*force.point));
        write("centre", json_vector(*force.point));
    }
    write("points", json_list(force.points, json_vector));
    write("axis", json_vector(force.axis));
    if (type.has("torsional_stiffness")) {
        write("axes", json_rows(force.axes, json_number));
        write("stiffness", json_vector(force.stiffnesses[0]));
        write("torsional_stiffness", json_vector(force.stiffnesses[1]));
        write("damping", json_vector(force.dampings[0]));
        write("torsional_damping", json_vector(force.dampings[1]));
    } else {
        write("stiffness", json_number(force.stiffness));
        write("damping", json_number(force.damping));
    }
    write("coefficients", json_list(force.coefficients, json_number));
    write("constant", json_number(force.attraction));
    write("mu", json_number(force.attraction));
    if (force.rest) { write(type.has("angle") ? "angle" : "length", json_number(*force.rest)); }
    write("turns", std::to_string(force.turns));
    write("amplitude", json_number(force.amplitude));
    write("frequency", json_number(force.frequency));
    return object.text();
}

const char* const shape_meaning =
    R"(how it is drawn, about the mass centre, m: {"type": "box", "size": [a, b, c]} along the body axes, )"
    R"({"type": "cylinder", "radius": r, "length": l}, {"type": "rod", "length": l}, which may have a radius, both )"
    R"(with an "axis" if it is not the third, or {"type": "sphere", "radius": r} (default: the homogeneous solid of )"
    R"(its mass and inertia))";

bool may_have_shape(const ElementType& body) { return body.has("inertia"); }

const std::vector<ElementType>& shape_types() {
    const ElementKey radius = {"radius", ValueKind::positive, true}, length = {"length", ValueKind::positive, true},
                     axis = {"axis", ValueKind::vector, false}, own_radius = {"radius", ValueKind::positive, false};
    static const std::vector<ElementType> types = {{"cylinder", "", {radius, length, axis}},
                                                   {"box", "", {{"size", ValueKind::vector, true}}},
                                                   {"sphere", "", {radius}},
                                                   {"rod", "", {length, own_radius, axis}}};
    return types;
}

std::string json_shape(const ShapeData& shape) {
    ObjectWriter object;
    object.member("type", json_text(shape.type));
    if (shape.radius) { object.member("radius", json_number(*shape.radius)); }
    if (shape.length) { object.member("length", json_number(*shape.length)); }
    if (shape.size) { object.member("size", json_list(*shape.size, json_number)); }
    if (shape.axis) { object.member("axis", json_list(*shape.axis, json_number)); }
    return object.text();
}

ShapeData shape_of_json(const JsonValue& json) {
    ShapeData shape{json.at("type").string()};
    if (const JsonValue* radius = json.find("radius")) { shape.radius = radius->number(); }
    if (const JsonValue* length = json.find("length")) { shape.length = length->number(); }
    if (const JsonValue* size = json.find("size")) { shape.size = three_numbers(*size); }
    if (const JsonValue* axis = json.find("axis")) { shape.axis = three_numbers(*axis); }
    if (!shape.radius && !shape.length && !shape.size) { throw std::invalid_argument("a shape has no size"); }
    return shape;
}

std::string json_with_shapes(const ParameterValue& value, const Shapes& shapes) {
    const auto* bodies = std::get_if<std::vector<BodyData>>(&value);
    if (bodies == nullptr) { return json_value(value); }
    return json_list(*bodies, [&](const BodyData& body) { return body_with_shape(body, shapes); });
}

}  // namespace kreisel
