// SPDX-License-Identifier: BSD-3-Clause
//
// The two-form of T*G over the vectors of a tangent frame at the start of a step, and over their images after it.
#pragma once

#include "engine/structure/observed_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// omega_0 and A^T omega_1 A, with mu = M v, in the vectors of a TangentFrame at the start of the step, where
/// omega_0/rate has the entries +- 1 and those of the momentum.
struct StepForms {
    MatX before, after;
    MatX coarse = {};          ///< `after` from the wider differences of StepDerivative
    Real rate = 0;             ///< of the motion, 1/s
    Real round_off = 0;        ///< of the Frobenius norm of after/rate
    std::string why_not = {};  ///< not empty: there are none, and why
};

/// A from differences. `sign` as in two_form. Not defined where the motion itself does not preserve the form (dampers,
/// loads, gravity that changes, rolling).
StepForms step_forms(const ObservedStep& at, const Real& sign = 1);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
