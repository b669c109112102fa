// SPDX-License-Identifier: BSD-3-Clause
//
// Joints as a user writes them down, checked and added to a model. Errors are ParameterErrors at JSON
// pointers below the parameters ("/joints/2/between/1").
#pragma once

#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Adds joints between bodies of the model, in the configuration the bodies have. Points and axes of the two bodies
/// need not meet: that is left to check_start and project_start. Axes of a universal joint must be perpendicular to
/// 1e-9, or to 30 degrees if the start will be projected.
void read_joints(Model& model, const std::vector<JointData>& joints, bool projected);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
