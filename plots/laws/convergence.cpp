// SPDX-License-Identifier: BSD-3-Clause
#include "plots/laws/convergence.hpp"

#include <algorithm>

#include "records/metrics/catalogue.hpp"

namespace kreisel {

const ResultRow* finest(const CellGroup& group) {
    const ResultRow* best = nullptr;
    for (const ResultRow* row : group.rows) {
        if (!row->ok()) { continue; }
        const bool finer = best == nullptr || row->steps > best->steps || row->tolerance < best->tolerance;
        best = finer ? row : best;
    }
    return best;
}

OrderLimits limits_of(const CellGroup& group, const std::string& metric) {
    OrderLimits limits;
    limits.epsilon = epsilon_of(group.front().precision);
    for (const ResultRow* row : group.rows) {
        const auto bound = row->reference_error.find(metric);
        if (row->ok() && row->metrics.contains(metric) && bound != row->reference_error.end()) {
            limits.reference_error = std::max(limits.reference_error, bound->second);
        }
    }
    if (const ResultRow* best = finest(group)) {
        const auto scale = best->scale.find(metric);
        if (scale != best->scale.end()) { limits.scale = scale->second; }
    }
    return limits;
}

ObservedOrder order_of(const CellGroup& group, const std::string& metric) {
    std::vector<ErrorPoint> points;
    for (const ResultRow* row : group.rows) {
        const auto error = row->metrics.find(metric);
        if (!row->ok() || row->adaptive() || error == row->metrics.end()) { continue; }
        points.push_back({row->steps, row->h, error->second});
    }
    return observed_order(std::move(points), limits_of(group, metric));
}

std::vector<std::string> error_metrics(const std::vector<ResultRow>& rows) {
    std::vector<std::string> found;
    const auto occurs = [&](const std::string& metric) {
        return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.metrics.contains(metric); });
    };
    for (const MetricDescription& entry : metric_catalogue()) {
        if (!is_error(entry)) { continue; }
        for (std::string& metric : names_of_metric(entry)) {
            if (occurs(metric)) { found.push_back(std::move(metric)); }
        }
    }
    return found;
}

}  // namespace kreisel
