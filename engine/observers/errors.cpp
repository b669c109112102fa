// SPDX-License-Identifier: BSD-3-Clause
#include "engine/observers/errors.hpp"

#include <utility>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

bool is_known(const Reference& reference, double t_end, const std::string& metric, const Real& error) {
    if (t_end <= reference.horizon) return true;
    const auto uncertainty = reference.error.find(metric);
    return uncertainty != reference.error.end() && error > 100 * from_number(uncertainty->second);
}

bool is_error(const Metric& metric, const std::vector<ConstraintRow>& rows) {
    return metric.description.kind == MetricKind::error && occurs(metric.description.rows, rows);
}

/// A state beside the reference of its time.
class Compared {
  public:
    Compared(const RunState& state, const ReportedState& reference, const std::vector<ConstraintRow>& rows)
        : exact_(from_report(reference)), comparison_{state.bodies, exact_, {distance(state.bodies, exact_)}} {
        std::vector<Real> lambda;
        for (const Number& row : reference.multipliers) lambda.push_back(from_number(row));
        if (!lambda.empty() && lambda.size() == state.multipliers.size())
            comparison_.apart.multipliers = multiplier_distance(rows, state.multipliers, lambda);
    }
    Compared(const Compared&) = delete;
    Compared& operator=(const Compared&) = delete;

    Real error(const Metric& metric) const {
        return metric.of_separation ? metric.of_separation(comparison_.apart) : metric.of_comparison(comparison_);
    }

  private:
    std::vector<BodyState> exact_;
    Comparison comparison_;
};

}  // namespace

void report_errors(const Reference& reference, double t_end, const RunState& end,
                   const std::vector<ConstraintRow>& rows, const std::vector<std::string>& patterns,
                   MeasuredMetrics& all) {
    if (reference.state.bodies.empty()) return;
    const Compared compared(end, reference.state, rows);
    for (const Metric& metric : metrics()) {
        if (!is_error(metric, rows)) continue;
        const std::string& name = metric.description.name;
        const Real error = compared.error(metric);
        if (is_known(reference, t_end, name, error)) add_measured(all, patterns, name, error);
    }
}

SampleErrors::SampleErrors(const Reference& reference, std::vector<ConstraintRow> rows,
                           const std::vector<std::string>& patterns)
    : reference_(reference), rows_(std::move(rows)), patterns_(patterns) {
    if (reference.samples.empty()) return;
    for (const Metric& metric : metrics())
        if (is_error(metric, rows_) && matches_any(patterns, metric.description.name + largest_of_error))
            entries_.push_back({&metric});
}

void SampleErrors::add(const RunState& sample) {
    const std::size_t k = taken_++;
    if (idle() || k == 0 || k > reference_.samples.size()) return;
    const Compared compared(sample, reference_.samples[k - 1].state, rows_);
    for (Entry& entry : entries_) keep_worst(entry.worst, compared.error(*entry.metric));
    ++compared_;
}

void SampleErrors::report(double t_end, MeasuredMetrics& all) const {
    if (compared_ < reference_.samples.size()) return;
    for (const Entry& entry : entries_) {
        const std::string name = entry.metric->description.name + largest_of_error;
        if (is_known(reference_, t_end, name, entry.worst)) add_measured(all, patterns_, name, entry.worst);
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
