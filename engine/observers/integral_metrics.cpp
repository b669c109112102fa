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
