// SPDX-License-Identifier: BSD-3-Clause
//
// The start of a model: whether it meets the constraints, and how it is brought onto them.
#pragma once

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Checks that a model starts on its constraints: each row of Phi is at most 1e-9 of its scale, each row of C v + b at
/// most 1e-9 of its scale times the rate of the motion (at rest, the rate that the forces would cause), plus in both
/// the round-off of data given in double precision, which grows with the distance from the origin; and the
/// accelerations satisfy redundant rows. Throws ParameterError naming the joints and their residuals.
void check_start(const Model& model);

/// How far project_start moved the bodies: the largest distance (m), angle (rad), change of velocity (m/s) and of
/// angular velocity (rad/s) of any of them.
struct StartCorrection {
    Real position = 0, rotation = 0, velocity = 0, omega = 0;
    bool noise = true;  ///< no more than the round-off of data given in double precision
};

/// Moves the start onto the constraints, first positions, then velocities, by steps of least norm in the metric M. Axes
/// that joints keep parallel come to point in one direction, whatever the angle between them. Throws ParameterError,
/// naming the joints and their residuals, if that does not converge, and on axes that are opposite.
StartCorrection project_start(Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
