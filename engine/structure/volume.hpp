// SPDX-License-Identifier: BSD-3-Clause
//
// How far a step is from preserving the volume of Liouville.
#pragma once

#include "engine/structure/observed_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// ||det A| - 1|, A the derivative of the step between vectors tangent to the constraints, measured by the volume
/// omega ^ ... ^ omega of the two-form: det A^2 = det(A^T omega_1 A) / det omega_0 (engine/structure/step_forms.hpp),
/// defined where the two-form is.
StepDefect volume_defect(const ObservedStep& at);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
