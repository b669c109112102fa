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

/// Times of N steps of one size from t_0 to T. Where t_0 is a whole number k of them after 0, up to round-off, they are
/// those of k + N steps from 0 to T, to the last bit.
class StepTimes {
  public:
    StepTimes() = default;
    StepTimes(const Real& begin, const Real& end, long steps);
    const Real& h() const { return h_; }
    Real at(long step) const;

  private:
    Real begin_ = 0, end_ = 0, origin_ = 0, h_ = 0;
    long before_ = 0, steps_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
