// SPDX-License-Identifier: BSD-3-Clause
//
// How the positions of a start are brought onto the joints.
#pragma once

#include "mechanics/start/start_state.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Gauss-Newton steps of least norm in the metric M onto Phi = 0, as far as round-off lets them.
void project_positions(StartState& start);

/// The model with bodies turned until axes that joints keep parallel, a_3 of the first body and b_3 of the second,
/// point in nearly the same direction. Rows that compare directions vanish for opposite axes too, and steps onto them
/// overshoot from 45 degrees on: the axes are therefore brought together in stages, of pi/8 at most, each of which
/// compares b_3 with a_3 turned by the angle that is left. The threads and teeth of a model take part once its axes
/// point in one direction. Throws ParameterError on axes that are opposite.
Model with_aligned_axes(const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
