// SPDX-License-Identifier: BSD-3-Clause
//
// References as the driver sees them: states and bounds of their errors as numbers.
#pragma once

#include "engine/engine.hpp"
#include "problems/problem.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Engine::reference; where the problem has a closed form, the distance from it counts as error too, unless the motion
/// begins elsewhere.
Reference reported_reference(const Problem& problem, const ParameterValues& values, const BeginState* begin,
                             double t_end, long samples, const Watch& watch);

/// Engine::check_reference.
ReferenceCheck checked_reference(const Problem& problem, const ParameterValues& values, const BeginState* begin,
                                 const Reference& reference);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
