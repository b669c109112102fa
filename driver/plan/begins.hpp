// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "driver/plan/plan.hpp"

namespace kreisel {

/// Asks the engines whether the problems of a plan, whose systems are known, can go on from the state that `time`
/// names; reports it where they cannot. Warns of drift, and of methods that start anew.
void check_begins(const Engines& engines, Diagnostics& sink, Plan& plan);

}  // namespace kreisel
