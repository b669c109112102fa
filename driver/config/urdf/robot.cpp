// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/urdf/robot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "records/json/diagnostics.hpp"
#include "support/nearest.hpp"

namespace kreisel::urdf {

namespace {

using Names = std::vector<std::string>;

bool is_among(const std::string& name, const Names& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string suggestion(const std::string& name, const Names& names) {
    const std::string nearest = nearest_name(name, names);
    return nearest.empty() ? "" : fmt::format("; did you mean {}?", in_quotes(nearest));
}

// Children that are neither read nor known to have no part in the motion.
void check_children(const Element& element, const Names& known) {
    for (const Element& child : element.children()) {
        if (is_among(child.tag(), known)) { continue; }
        const std::string nearest = nearest_name(child.tag(), known);
        if (nearest.empty()) {
            child.complaints().remark(fmt::format("<{}> has no part in the motion", child.tag()));
        } else {
            child.error(fmt::format("expected <{}>, got <{}>", nearest, child.tag()));
        }
    }
}

Matrix read_inertia(const Element& element) {
    const auto entry = [&](const char* name) { return element.required_number(name); };
    const double xx = entry("ixx"), yy = entry("iyy"), zz = entry("izz");
    const double xy = entry("ixy"), xz = entry("ixz"), yz = entry("iyz");
    return {{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
}

std::optional<Inertial> read_inertial(const Element& element) {
    check_children(element, {"origin", "mass", "inertia"});
    const auto mass = element.require("mass"), inertia = element.require("inertia");
    if (!mass || !inertia) { return std::nullopt; }
    const double value = mass->required_number("value");
    if (value < 0) { mass->error(fmt::format("expected a mass that is not negative, got {}", value)); }
    const Pose frame = read_origin(element);
    const Matrix about_centre = read_inertia(*inertia);
    if (!(value > 0)) { return std::nullopt; }
    return Inertial{value, frame.p, turned(frame.R, about_centre)};
}

Link read_link(const Element& element) {
    check_children(element, {"inertial", "visual", "collision"});
    const auto inertial = element.child("inertial");
    return {element.text("name"), inertial ? read_inertial(*inertial) : std::nullopt, read_solid(element),
            element.line()};
}

Vector read_axis(const Element& element) {
    const auto axis = element.child("axis");
    const Vector direction = to_vector(axis ? axis->vector("xyz", {1, 0, 0}) : std::array<double, 3>{1, 0, 0});
    if (boost::qvm::mag(direction) > 0) { return boost::qvm::normalized(direction); }
    axis->error("expected a direction as xyz, got a vector of length 0");
    return {1, 0, 0};
}

std::string read_type(const Element& element) {
    const Names known = {"revolute", "continuous", "prismatic", "fixed", "floating"};
    std::string type = element.text("type");
    if (!type.empty() && !is_among(type, known)) {
        element.error(fmt::format("expected a joint that is {}, got {}{}", fmt::join(known, ", "), in_quotes(type),
                                  suggestion(type, known)));
    }
    return type;
}

double read_damping(const Element& element) {
    const auto dynamics = element.child("dynamics");
    if (!dynamics) { return 0; }
    if (dynamics->number("friction", 0) != 0) {
        element.complaints().remark(fmt::format("the dry friction of {} is left out", element.shown()));
    }
    const double damping = dynamics->number("damping", 0);
    if (damping < 0) { dynamics->error(fmt::format("expected a damping that is not negative, got {}", damping)); }
    return damping;
}

Joint read_joint(const Element& element) {
    check_children(element, {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic", "calibration",
                             "safety_controller"});
    if (element.child("mimic")) { element.error("expected a joint that moves by itself, got one with <mimic>"); }
    const auto parent = element.require("parent"), child = element.require("child");
    Joint joint{element.text("name"),
                read_type(element),
                parent ? parent->text("link") : "",
                child ? child->text("link") : "",
                read_origin(element),
                read_axis(element),
                read_damping(element),
                element.line()};
    if (element.child("limit") && joint.type != "continuous") {
        element.complaints().remark("joints move past their <limit>");
    }
    return joint;
}

template <class Parts>
void check_names(const Parts& parts, const char* what, Complaints& complaints) {
    Names known;
    for (const auto& part : parts) {
        if (is_among(part.name, known)) {
            complaints.add(part.line, fmt::format("expected {}s with different names, got a second {}", what,
                                                  in_quotes(part.name)));
        }
        known.push_back(part.name);
    }
}

// Each joint between links that are there, and each link with one parent.
void check_tree(const Robot& robot, Complaints& complaints) {
    Names links, children;
    for (const Link& link : robot.links) { links.push_back(link.name); }
    for (const Joint& joint : robot.joints) {
        for (const std::string& end : {joint.parent, joint.child}) {
            if (end.empty() || is_among(end, links)) { continue; }
            complaints.add(joint.line, fmt::format("<joint {}>: expected the name of a link, got {}{}",
                                                   in_quotes(joint.name), in_quotes(end), suggestion(end, links)));
        }
        if (is_among(joint.child, children)) {
            complaints.add(joint.line, fmt::format("<joint {}>: expected a tree, got a second joint that carries {}",
                                                   in_quotes(joint.name), in_quotes(joint.child)));
        }
        children.push_back(joint.child);
    }
}

}  // namespace

Robot read_robot(const Element& root) {
    if (root.tag() != "robot") { root.error(fmt::format("expected <robot>, got <{}>", root.tag())); }
    check_children(root, {"link", "joint", "material"});
    Robot robot;
    for (const Element& element : root.children()) {
        if (element.tag() == "link") { robot.links.push_back(read_link(element)); }
        if (element.tag() == "joint") { robot.joints.push_back(read_joint(element)); }
    }
    check_names(robot.links, "link", root.complaints());
    check_names(robot.joints, "joint", root.complaints());
    check_tree(robot, root.complaints());
    return robot;
}

}  // namespace kreisel::urdf
