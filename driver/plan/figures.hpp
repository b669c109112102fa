// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the experiment produces what its figures show.
#pragma once

#include "driver/plan/plan.hpp"

namespace kreisel {

/// Reports to `sink` each figure of the config that could not be drawn whatever the outcome of the cells: trajectories
/// where no samples are stored, metrics that do not exist or are not measured, a selection that matches nothing in the
/// experiment. `metrics` are the names of all metrics the problems of the plan have.
void check_figures(const Document& document, const Plan& plan, const std::vector<std::string>& metrics,
                   Diagnostics& sink);

}  // namespace kreisel
