// SPDX-License-Identifier: BSD-3-Clause
#include "engine/observers/errors.hpp"

#include <limits>
#include <map>
#include <utility>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using Uncertainties = std::map<std::string, Number>;

bool is_above(const Uncertainties& uncertainties, const std::string& metric, const Real& error) {
    const auto uncertainty = uncertainties.find(metric);
    return uncertainty != uncertainties.end() && error > 100 * from_number(uncertainty->second);
}

bool is_known(const Reference& reference, double t_end, const std::string& metric, const Real& error) {
    return t_end <= reference.horizon || is_above(reference.error, metric, error);
}

Real if_known(const ReferenceSample& sample, double horizon, const std::string& metric, const Real& error) {
    const bool known = sample.state.t.value <= horizon || is_above(sample.error, metric, error);
    return known ? error : std::numeric_limits<Real>::quiet_NaN();
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
    for (Entry& entry : entries_) entry.last = std::numeric_limits<Real>::quiet_NaN();
    if (idle() || k == 0 || k > reference_.samples.size()) return;
    const ReferenceSample& exact = reference_.samples[k - 1];
    const Compared compared(sample, exact.state, rows_);
    for (Entry& entry : entries_) {
        const Real error = compared.error(*entry.metric);
        keep_worst(entry.worst, error);
        entry.last = if_known(exact, reference_.horizon, entry.metric->description.name, error);
    }
    ++compared_;
}

void SampleErrors::add_columns(std::vector<Column>& all) const {
    for (const Entry& entry : entries_) all.push_back({entry.metric->description.name, entry.metric->description.unit});
}

void SampleErrors::append_values(std::vector<Real>& row) const {
    for (const Entry& entry : entries_) row.push_back(entry.last);
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
