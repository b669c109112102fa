// SPDX-License-Identifier: BSD-3-Clause
//
// What a steady motion is made of, for readers.
#pragma once

#include <vector>

#include "engine/engine.hpp"
#include "engine/linearised/symmetries.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The rotation, the translation and the spins of a generator; none of an equilibrium. Parts that are round-off of the
/// rate of the motion (1/s) are left out.
std::vector<MotionPart> motion_parts(const Model& model, const Generator& c, const Real& rate);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
