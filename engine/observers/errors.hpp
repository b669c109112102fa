// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "engine/observers/measured.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Adds the requested error metrics of a run that has ended at t_end (s). `multipliers`: of the last state, empty where
/// they are not known. Past the horizon of the reference, a distance from it is meaningful only if far above the
/// uncertainty: an error is then given above 100 times that.
void report_errors(const Reference& reference, double t_end, const std::vector<BodyState>& states,
                   const std::vector<Real>& multipliers, const std::vector<ConstraintRow>& rows,
                   const std::vector<std::string>& patterns, MeasuredMetrics& all);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
