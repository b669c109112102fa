// SPDX-License-Identifier: BSD-3-Clause
//
// How a body looks: the shape that its config gives, else a homogeneous solid of the same mass and inertia.
#pragma once

#include <array>

#include "engine/geometry.hpp"
#include "records/json/model.hpp"

namespace kreisel {

/// A symmetric 3x3 matrix as R diag(values) R^T; the columns of R, a rotation, are `axes`.
struct PrincipalMoments {
    Vector3 values{};
    std::array<Vector3, 3> axes{};
};
/// By Jacobi's rotations.
PrincipalMoments principal_moments(const Matrix3& symmetric);

/// A solid about the mass centre. sphere: sizes are three equal diameters; cylinder: along axes[2], sizes are
/// diameter, diameter, height; box: three edges (m). point: a point mass; sizes are zero.
struct BodyShape {
    enum class Kind { point, sphere, cylinder, box } kind = Kind::point;
    Vector3 sizes{};
    std::array<Vector3, 3> axes{};  ///< in body axes, right-handed
};

/// With the principal moments A, B, C of a mass m: a homogeneous box has edges a^2 = 6 (B + C - A) / m; where two
/// moments are equal up to 1e-6, a cylinder has r^2 = 2 C / m and h^2 = 12 A / m - 3 r^2; where all are, a sphere has
/// r^2 = 5 A / (2 m). No edge is drawn below 1/25 of the longest.
BodyShape shape_of(const BodyGeometry& body);
/// The shape of these that has its name, as large as it is given, a rod without a radius with 1/50 of its length as
/// radius; else that.
BodyShape shape_of(const BodyGeometry& body, const Shapes& shapes);

}  // namespace kreisel
