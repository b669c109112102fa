// SPDX-License-Identifier: BSD-3-Clause
//
// The derivative of a step by differences.
#pragma once

#include <vector>

#include "engine/structure/motion_units.hpp"
#include "engine/structure/observed_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A, the derivative of y -> y_1 = the state after the step, left-trivialised at both ends: y exp(e X) goes to
/// y_1 exp(e A X + ...). Central differences at e, e/2 and e/4, extrapolated over pairs of them.
struct StepDerivative {
    std::vector<Real> y1;
    MatX fine, coarse;  ///< A X of the columns X from e/2 and e/4, and from e and e/2: the first has some 1/16 of
                        ///< the truncation error of the other, and four times its round-off
    Status status = Status::ok;  ///< of a step that failed; then there is no derivative

    static Real round_off();  ///< of an entry of A X, of X of size 1, if a step had only that of one operation
};

/// Along the columns of X, each of a length that moves the state by e in units of the motion, whose rate (1/s) is
/// given.
StepDerivative derivative_of(const ObservedStep& at, const MatX& X, MotionUnits& units, const Real& rate);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
