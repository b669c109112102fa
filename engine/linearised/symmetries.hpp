// SPDX-License-Identifier: BSD-3-Clause
//
// Symmetries of the equations of motion of a model: rigid motions of space that leave its gravity, its loads and its
// ties to the ground as they are, and spins of bodies about axes of symmetry. Other than those behind first integrals
// (mechanics/model/symmetries.hpp) they include those of rolling bodies, which conserve nothing.
#pragma once

#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A one-parameter group exp(t a), exp(t b) that acts on states as exp(t a) y exp(t b): points P of space move with
/// u + w x P, and each body spins with spins[i] (rad/s, body axes) about its mass centre.
struct Generator {
    Vec3 w = Vec3::Zero();  ///< rad/s
    Vec3 u = Vec3::Zero();  ///< m/s, of the origin
    std::vector<Vec3> spins;
};

/// A basis of the symmetries of space of a model (at most 6, spins zero); its rotations are about lines near the model,
/// lengths in units of its extent.
std::vector<Generator> space_symmetries(const Model& model);

/// The spin by 1 rad/s of each body that has an axis of symmetry on which all joints and forces act.
std::vector<Generator> spin_symmetries(const Model& model);

/// The sum of all factor_i all_i.
Generator combination(const std::vector<Generator>& all, const VecX& factors);

/// Why the equations of motion depend on time by themselves; empty if they do not.
std::string why_not_autonomous(const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
