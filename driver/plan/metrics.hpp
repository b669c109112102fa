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

/// The plain names among the metrics of the config that none of `names`, all metrics, is.
std::vector<std::string> unknown_metrics(const std::vector<std::string>& names, const Config& config);

/// A plain name must be one of `names`, all metrics, or of those `taken` away with their problems by a filter, which
/// are left out with a warning. A pattern that matches nothing and a metric that cannot be measured here give warnings.
void check_metrics(const std::vector<std::string>& names, const std::vector<std::string>& taken, Diagnostics& sink,
                   Plan& plan);

}  // namespace kreisel
