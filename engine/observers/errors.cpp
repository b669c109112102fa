// SPDX-License-Identifier: BSD-3-Clause
#include "engine/observers/errors.hpp"

#include "engine/metrics/metric.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

bool is_known(const Reference& reference, double t_end, const std::string& metric, const Real& error) {
    if (t_end <= reference.horizon) return true;
    const auto uncertainty = reference.error.find(metric);
    return uncertainty != reference.error.end() && error > 100 * from_number(uncertainty->second);
}

}  // namespace

void report_errors(const Reference& reference, double t_end, const std::vector<BodyState>& states,
                   const std::vector<Real>& multipliers, const std::vector<ConstraintRow>& rows,
                   const std::vector<std::string>& patterns, MeasuredMetrics& all) {
    if (reference.state.bodies.empty()) return;
    const std::vector<BodyState> exact = from_report(reference.state);
    std::vector<Real> exact_multipliers;
    for (const Number& row : reference.state.multipliers) exact_multipliers.push_back(from_number(row));
    Comparison comparison{states, exact, {distance(states, exact)}};
    if (!multipliers.empty() && multipliers.size() == exact_multipliers.size())
        comparison.apart.multipliers = multiplier_distance(rows, multipliers, exact_multipliers);
    for (const Metric& metric : metrics()) {
        if (metric.description.kind != MetricKind::error || !occurs(metric.description.rows, rows)) continue;
        const std::string& name = metric.description.name;
        const Real error =
            metric.of_separation ? metric.of_separation(comparison.apart) : metric.of_comparison(comparison);
        if (is_known(reference, t_end, name, error)) add_measured(all, patterns, name, error);
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
