// SPDX-License-Identifier: BSD-3-Clause
//
// What a link of a URDF file looks like. Internal to the reader of URDF.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "driver/config/urdf/element.hpp"
#include "driver/config/urdf/pose.hpp"

namespace kreisel::urdf {

/// A box, a cylinder along its third axis, or a sphere, about the origin of a frame in the frame of a link.
struct Solid {
    std::string type;
    Vector sizes;  ///< edges; diameter, diameter, length; three diameters (m)
    Pose frame;
};

/// The first such geometry of <visual>, else of <collision>; nothing where there is none, or one without extent.
std::optional<Solid> read_solid(const Element& link);

/// As the "shape" of a body with this mass centre and the axes of the link; null where the solid has another centre, by
/// more than 1/20 of its size, or a box lies askew.
nlohmann::json shape_about(const Solid& solid, const Vector& centre);

}  // namespace kreisel::urdf
