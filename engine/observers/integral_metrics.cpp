// SPDX-License-Identifier: BSD-3-Clause
#include "engine/observers/integral_metrics.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const char* const suffixes[] = {"", ".final", ".relative", ".slope", ".slope_error"};

}  // namespace

IntegralMetrics::IntegralMetrics(System& system, const std::vector<std::string>& patterns) : patterns_(patterns) {
    for (const FirstIntegral& integral : system.integrals()) {
        const std::string name = "invariant." + integral.name;
        if (any_matches(patterns_, name, suffixes)) entries_.push_back({&integral, name});
    }
}

void IntegralMetrics::observe(Observation& now) {
    if (entries_.empty()) return;
    const MotionState state = now.motion();
    for (Entry& entry : entries_) {
        const Real value = entry.source->value(state);
        if (!started_) {
            entry.start = value;
            // A start value below the round-off of its terms is zero, and relative values are undefined.
            entry.has_relative = abs(value) > 100 * epsilon * entry.source->size(state);
        }
        entry.now = value - entry.start;
        keep_worst(entry.worst, abs(entry.now));
        entry.fit.add(now.t(), entry.now);
    }
    started_ = true;
}

void IntegralMetrics::report(bool finished, MeasuredMetrics& all) const {
    for (const Entry& entry : entries_) {
        const auto add = [&](const char* suffix, const Real& value) {
            add_measured(all, patterns_, entry.name + suffix, value);
        };
        add("", entry.worst);
        if (entry.has_relative) add(".relative", entry.worst / abs(entry.start));
        if (finished) add(".final", abs(entry.now));
        if (!finished || entry.fit.points() < 3) continue;
        add(".slope", entry.fit.slope());
        add(".slope_error", entry.fit.slope_error());
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
