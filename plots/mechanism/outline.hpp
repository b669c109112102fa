// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies as lines, for drawings on paper.
#pragma once

#include <vector>

#include "engine/geometry.hpp"
#include "records/json/model.hpp"

namespace kreisel {

using Polyline = std::vector<Vector3>;

/// The edges of a body's solid (plots/mechanism/shape.hpp), and lines from its mass centre to the points of its joints
/// and forces, in body axes about the mass centre (m).
std::vector<Polyline> outline_of(const BodyGeometry& body, const Geometry& mechanism, const Shapes& shapes = {});

/// x + R p of each point; R row by row.
Polyline moved(const Polyline& line, const Vector3& x, const Matrix3& R);

}  // namespace kreisel
