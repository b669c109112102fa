// SPDX-License-Identifier: BSD-3-Clause
//
// A step with scripted accelerations, so that the slopes of the stages do not commute and do not depend on the state:
// of the running code, and to be evaluated from a scheme.
#pragma once

#include "tests/judges/families/dense_step.hpp"
#include "tests/judges/methods/checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct Scenario {
    MatrixGroup group;
    Real t, h;
    VecX y;  ///< initial state as stored
    std::vector<VecX> script;
};

/// A step whose rotations are of order one, so that every term of dexpinv shows. `magnitude` is that of the scheme:
/// what it multiplies the slopes by must stay within the charts.
Scenario scenario(const MatrixGroup& group, std::size_t stages, const Real& magnitude);

/// The scenario as a step to evaluate.
ScriptedStep scripted(const Scenario& scenario, const OptionValues& options, int order);

/// What the running code does: where it asks for slopes, the result, and of an attempt the estimate of its error.
/// Throws std::domain_error if it ends in a status that is not ok, std::out_of_range if it asks for more slopes than
/// there are.
DenseStep running_step(const Method& method, const OptionValues& options, const Scenario& scenario);
DenseStep running_attempt(const Method& method, const OptionValues& options, const Scenario& scenario);

/// Largest difference of an entry; infinite if one is not finite.
Real distance(const DensePoint& a, const DensePoint& b);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
