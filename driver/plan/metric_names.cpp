// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/metric_names.hpp"

#include <algorithm>

#include "records/metrics/catalogue.hpp"
#include "support/pattern.hpp"

namespace kreisel {

std::vector<std::string> metric_names(const std::vector<std::string>& integrals) {
    std::vector<std::string> names = names_of_metrics();
    for (const std::string& integral : integrals) {
        for (const IntegralSuffix& suffix : integral_suffixes) {
            names.push_back("invariant." + integral + suffix.name);
        }
    }
    return names;
}

bool asks_for_errors(const std::vector<std::string>& patterns) {
    const auto& all = metric_catalogue();
    return std::any_of(all.begin(), all.end(), [&](const MetricDescription& metric) {
        return is_error(metric) && matches_any(patterns, metric.name);
    });
}

bool asks_for_largest_errors(const std::vector<std::string>& patterns) {
    const auto& all = metric_catalogue();
    return std::any_of(all.begin(), all.end(), [&](const MetricDescription& metric) {
        return is_error(metric) && matches_any(patterns, metric.name + largest_of_error);
    });
}

}  // namespace kreisel
