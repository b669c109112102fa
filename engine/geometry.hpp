// SPDX-License-Identifier: BSD-3-Clause
//
// The geometry of a mechanism, free of `Real`: with the poses of its bodies, all that is needed to draw it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mechanics/model/data.hpp"

namespace kreisel {

/// Inertia about the mass centre, body axes (kg m^2); of a point mass zero.
struct BodyGeometry {
    std::string name;
    double mass = 0;
    Matrix3 inertia = {};
    bool operator==(const BodyGeometry&) const = default;
};

/// What joins two bodies, or a body and "ground": its points (m) in the axes of each body, from the mass centre; of the
/// ground in space coordinates. Those of a force that has no point are 0.
struct LinkGeometry {
    std::string name;
    std::string type;  ///< of a joint or a force, such as "revolute" or "spring"
    std::array<std::string, 2> between = {};
    std::array<Vector3, 2> points = {};
    std::vector<Vector3> axes = {};  ///< of the joint, in the axes of each body: two unit vectors, or none
    double length = 0;               ///< of a distance joint; of a rolling joint the radius (m)
    bool operator==(const LinkGeometry&) const = default;
};

struct Geometry {
    std::vector<BodyGeometry> bodies;
    std::vector<LinkGeometry> links;  ///< joints, then forces between bodies
    bool operator==(const Geometry&) const = default;
};

}  // namespace kreisel
