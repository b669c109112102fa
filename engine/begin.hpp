// SPDX-License-Identifier: BSD-3-Clause
//
// Runs that go on from a state, such as a sample of an earlier run. The model is that of its own initial configuration,
// in which joints have their points and axes; bodies and full turns of torsion springs are where the state has them.
#pragma once

#include <vector>

#include "engine/engine.hpp"
#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Why a state is none of a model: its bodies or springs have other names; empty if it is.
std::string why_not_of(const Model& model, const BeginState& begin);

/// A model whose bodies start in a state of it; nothing else changes.
Model moved_to(Model model, const BeginState& begin);

/// Whether a system in a formulation holds a state: up to 1e-9 of the mechanism's extent, of 1 for rotations, and of
/// the largest velocity. One on SO3 has its fixed points where they are, whatever the state says.
BeginCheck checked_begin(const Model& model, const std::string& formulation, const BeginState& begin);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
