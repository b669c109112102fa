// SPDX-License-Identifier: BSD-3-Clause
//
// The fixed points about which bodies turn, whatever their rotations are stored as.
#pragma once

#include <string>
#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A body that turns about a point: its mass, J_O = J + m (|c|^2 I - c c^T) and the inverse, the point in space axes,
/// and the lever c from there to the mass centre in body axes.
struct Pivoted {
    Real mass;
    Mat3 J_O, J_O_inverse;
    Vec3 pivot, lever;
};

/// Of each body of a model for which `why_not_pivoted` is empty.
std::vector<Pivoted> pivoted_bodies(const Model& model);

/// Why this formulation cannot have all bodies turn about fixed points; empty if it can: each body hangs on the ground
/// by at most one spherical joint, and one without is at rest.
std::string why_not_pivoted(const Model& model, const std::string& formulation);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
