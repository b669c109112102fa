// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/model.hpp"

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

}  // namespace kreisel
