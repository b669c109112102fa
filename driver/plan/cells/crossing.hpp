// SPDX-License-Identifier: BSD-3-Clause
//
// The cross product of the axes of a config.
#pragma once

#include "driver/plan/plan.hpp"

namespace kreisel {

/// Adds the cells to a plan whose systems are known, with the references they need. Reports what an engine objects to
/// in options and parameters.
void cross_axes(const Engines& engines, Diagnostics& sink, Plan& plan);

}  // namespace kreisel
