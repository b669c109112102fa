// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the problems of a plan have the metrics that its config names.
#pragma once

#include <string>
#include <vector>

#include "driver/plan/plan.hpp"

namespace kreisel {

/// All metrics that the problems of the plan have.
std::vector<std::string> known_metrics(const Plan& plan);

/// A plain name must be one of `names`, all metrics; a pattern that matches nothing and a metric that cannot be
/// measured here give warnings.
void check_metrics(const std::vector<std::string>& names, Diagnostics& sink, Plan& plan);

}  // namespace kreisel
