// SPDX-License-Identifier: BSD-3-Clause
#include "engine/observers/step_metrics.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const char* const suffixes[] = {"", ".final"};

}  // namespace

StepMetrics::StepMetrics(System& system, const std::vector<std::string>& patterns) : patterns_(patterns) {
    const auto rows = system.constraint_rows();
    for (const Metric& metric : metrics())
        if (metric.of_step && occurs(metric.description.rows, rows) &&
            any_matches(patterns_, metric.description.name, suffixes))
            entries_.push_back({&metric});
}

void StepMetrics::look(Observation& now) {
    for (Entry& entry : entries_) entry.now = entry.metric->of_step(now);
}

void StepMetrics::observe(Observation& now) {
    look(now);
    for (Entry& entry : entries_) keep_worst(entry.worst, entry.now);
}

void StepMetrics::report(bool finished, MeasuredMetrics& all) const {
    for (const Entry& entry : entries_) {
        const std::string& name = entry.metric->description.name;
        if (!finished && !isfinite(entry.worst)) continue;
        add_value(all, patterns_, name, entry.worst);
        if (finished) add_value(all, patterns_, name + ".final", entry.now);
    }
}

void StepMetrics::add_columns(std::vector<Column>& all) const {
    for (const Entry& entry : entries_) {
        const MetricDescription& metric = entry.metric->description;
        all.push_back({metric.name, metric.unit});
        all.push_back({metric.name + ".max", metric.unit});
    }
}

void StepMetrics::append_values(std::vector<Real>& row) const {
    for (const Entry& entry : entries_) row.insert(row.end(), {entry.now, entry.worst});
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
