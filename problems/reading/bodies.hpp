// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies as a user writes them down, checked and added to a model. Errors are ParameterErrors at JSON
// pointers below the parameters ("/bodies/2/inertia").
#pragma once

#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Adds bodies with different names: masses, inertias that a body can have, rotations. A body without v starts with
/// v = 0.
void read_bodies(Model& model, const std::vector<BodyData>& bodies);
/// What each body has of its own; the argument of complete_velocities.
GivenVelocities given_velocities(const std::vector<BodyData>& bodies);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
