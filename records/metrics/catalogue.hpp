// SPDX-License-Identifier: BSD-3-Clause
//
// The metrics of the engine, as records, tables, figures and the driver look them up.
#pragma once

#include <string>
#include <vector>

#include "engine/engine.hpp"

namespace kreisel {

/// All of Engine::metrics, in the order in which results hold them.
const std::vector<MetricDescription>& metric_catalogue();

/// A distance from the reference at the end; "NAME.max" is the largest over the samples.
inline bool is_error(const MetricDescription& metric) { return metric.kind == MetricKind::error; }

/// What single steps do to the geometry of the motion; "NAME.uncertainty" is what it is certain to.
inline bool is_structure(const MetricDescription& metric) { return metric.kind == MetricKind::structure; }

/// The names of what they measure, those of largest and final values among them.
const std::vector<std::string>& names_of_metrics();

/// The entry of a name, with or without ".final", ".max" or ".uncertainty"; null where there is none.
const MetricDescription* find_metric(const std::string& name);

/// The names under which it is measured: itself, and with its suffix.
inline std::vector<std::string> names_of_metric(const MetricDescription& metric) {
    const char* const suffix = is_error(metric)       ? largest_of_error
                               : is_structure(metric) ? uncertainty_of_structure
                                                      : final_of_defect;
    return {metric.name, metric.name + suffix};
}
/// Whether a name is that of a maximum over samples.
bool is_largest_error(const std::string& name);

/// One error of a level, for what holds for all of them.
std::string metric_of(MetricLevel level);

}  // namespace kreisel
