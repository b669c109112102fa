// SPDX-License-Identifier: BSD-3-Clause
//
// What a URDF file says of the motion of a robot. Internal to the reader of URDF.
// Source of the format: http://wiki.ros.org/urdf/XML.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/config/urdf/element.hpp"
#include "driver/config/urdf/pose.hpp"
#include "driver/config/urdf/solid.hpp"

namespace kreisel::urdf {

/// Of a link, in its frame.
struct Inertial {
    double mass;     ///< kg
    Vector centre;   ///< m
    Matrix inertia;  ///< about the mass centre, axes of the link, kg m^2
};

struct Link {
    std::string name;
    std::optional<Inertial> inertial;  ///< none: a frame without mass
    std::optional<Solid> solid;        ///< none: it is not told how it looks
    int line;
};

struct Joint {
    std::string name, type, parent, child;
    Pose origin;  ///< of the child's frame in the parent's, where the coordinate of the joint is 0
    Vector axis;  ///< of length 1, in the child's frame
    double damping;
    int line;

    bool turns() const { return type == "revolute" || type == "continuous"; }
    bool slides() const { return type == "prismatic"; }
    bool moves() const { return turns() || slides(); }
};

struct Robot {
    std::vector<Link> links;
    std::vector<Joint> joints;
};

/// Reads <robot>. What is wrong goes to the complaints of the element, and so does what has no part in the motion here
/// and would have in reality, as a remark.
Robot read_robot(const Element& root);

}  // namespace kreisel::urdf
