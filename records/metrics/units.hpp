// SPDX-License-Identifier: BSD-3-Clause
//
// Units of metrics.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/engine.hpp"

namespace kreisel {

/// By metric without suffix: "error.position", "invariant.energy".
using Units = std::map<std::string, std::string>;

/// Those of the metrics of the engine and of these first integrals; an integral that two systems declare in different
/// units has none.
Units units_of_metrics(const std::vector<IntegralDescription>& integrals);

/// Results before format 2 say nothing of units: those of the integrals that there were, by their names.
Units units_before_format_2(const std::vector<std::string>& metrics);

/// Unit of a metric with or without a suffix ("invariant.energy.slope"); empty where it is not known.
std::string metric_unit(const std::string& metric, const Units& units);

}  // namespace kreisel
