// SPDX-License-Identifier: BSD-3-Clause
//
// How a perturbation of the start grows along a motion, measured in quad whatever the precision under test (in double
// only if a build has no quad): this header depends on neither.
#pragma once

#include <array>
#include <string>

namespace kreisel::growing {

enum Cause { of_position, of_rotation, of_velocity, of_omega, causes };
enum Effect { on_position, on_rotation, on_velocity, on_omega, on_force, on_torque, effects };

/// Largest |change at the end| over the size of the change of the start that caused it, each in its own unit.
using Growth = std::array<std::array<double, causes>, effects>;

/// Of a model of named_models.hpp over some steps of h, by rkmk/rk4, with projection of positions and velocities or
/// without. Cached.
const Growth& growth(const std::string& model, double h, int steps, bool projected);

}  // namespace kreisel::growing
