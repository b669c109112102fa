// SPDX-License-Identifier: BSD-3-Clause
#include "engine/observers/integral_metrics.hpp"

#include <algorithm>
#include <iterator>

#include "engine/metrics/description.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

IntegralMetrics::IntegralMetrics(System& system, const std::vector<std::string>& patterns) : patterns_(patterns) {
    if (patterns.empty()) return;
    for (const FirstIntegral& integral : system.integrals()) {
        const std::string name = "invariant." + integral.name;
        if (is_requested(name)) entries_.push_back({&integral, name});
    }
}

bool IntegralMetrics::is_requested(const std::string& name) const {
    return std::any_of(std::begin(integral_suffixes), std::end(integral_suffixes),
                       [&](const IntegralSuffix& suffix) { return matches_any(patterns_, name + suffix.name); });
}

void IntegralMetrics::begin(const MotionState& state) {
    for (Entry& entry : entries_) {
        entry.start = entry.source->value(state);
        // A start value below the round-off of its terms is zero, and relative values are undefined.
        entry.has_relative = abs(entry.start) > 100 * epsilon * entry.source->size(state);
    }
    started_ = true;
}

void IntegralMetrics::look(Observation& now) {
    if (entries_.empty()) return;
    const MotionState state = now.motion();
    for (Entry& entry : entries_) entry.now = entry.source->value(state) - entry.start;
}

void IntegralMetrics::observe(Observation& now) {
    if (entries_.empty()) return;
    if (!started_) begin(now.motion());
    look(now);
    for (Entry& entry : entries_) {
        keep_worst(entry.worst, abs(entry.now));
        entry.fit.add(now.t(), entry.now);
    }
}

void IntegralMetrics::report(bool finished, MeasuredMetrics& all) const {
    for (const Entry& entry : entries_) {
        const auto add = [&](const IntegralSuffix& suffix, const Real& value) {
            add_measured(all, patterns_, entry.name + suffix.name, value);
        };
        if (finished && !isfinite(entry.worst)) add_value(all, patterns_, entry.name, entry.worst);
        add(largest_of_integral, entry.worst);
        if (entry.has_relative) add(relative_of_integral, entry.worst / abs(entry.start));
        if (finished) add(final_of_integral, abs(entry.now));
        if (!finished || entry.fit.points() < 3) continue;
        add(slope_of_integral, entry.fit.slope());
        add(slope_error_of_integral, entry.fit.slope_error());
    }
}

void IntegralMetrics::add_columns(std::vector<Column>& all) const {
    for (const Entry& entry : entries_) {
        all.push_back({entry.name, entry.source->unit});
        all.push_back({entry.name + ".max", entry.source->unit});
    }
}

void IntegralMetrics::append_values(std::vector<Real>& row) const {
    for (const Entry& entry : entries_) row.insert(row.end(), {entry.now, entry.worst});
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
