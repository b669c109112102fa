// SPDX-License-Identifier: BSD-3-Clause
//
// How far a step is from preserving the two-form of T*G.
#pragma once

#include "engine/structure/observed_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// |A^T omega_1 A - omega_0|/rate, with mu = M v, in the vectors of a TangentFrame at the start of the step, where
/// omega_0 has the entries +- 1 and those of the momentum; Frobenius norm. A from differences, whose uncertainty is
/// that of the value. `sign` as in two_form.
/// Not defined where the motion itself does not preserve the form (dampers, loads, gravity that changes, rolling).
StepDefect symplecticity_defect(const ObservedStep& at, const Real& sign = 1);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
