// SPDX-License-Identifier: BSD-3-Clause
//
// How far a step is from being its own adjoint.
#pragma once

#include "engine/structure/observed_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// |log(y^{-1} y')| where y' is reached from y by a step by h and one by -h: the largest of angles, positions over the
/// length of the mechanism, and velocities over these times the rate of the motion. The uncertainty is the round-off of
/// some hundreds of operations.
StepDefect reversal_defect(const ObservedStep& at);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
