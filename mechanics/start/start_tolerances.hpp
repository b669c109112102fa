// SPDX-License-Identifier: BSD-3-Clause
//
// When a start meets its joints, and when a change of it is round-off.
#pragma once

#include "mechanics/start.hpp"
#include "mechanics/start/start_state.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Throws ParameterError, with the residual of each joint, unless every row of Phi is at most 1e-9 of its scale, plus
/// round-off.
void require_positions(StartState& start);
/// Throws ParameterError unless every row of C v + b is at most 1e-9 of its scale times the rate of the motion, plus
/// round-off.
void require_velocities(StartState& start);

/// Whether every row of Phi is round-off of its terms.
bool is_round_off(StartState& start, const VecX& phi);
/// Whether a correction is round-off of arithmetic on the data. A position's round-off rotates a body by that over the
/// size of the mechanism.
bool is_noise(StartState& start, const StartCorrection& moved);
/// Projecting out a motion that the joints do not allow leaves round-off: zero it.
void stop_noise(StartState& start, const Real& speed_before);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
