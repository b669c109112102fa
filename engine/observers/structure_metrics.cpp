// SPDX-License-Identifier: BSD-3-Clause
#include "engine/observers/structure_metrics.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const char* const suffixes_of_structures[] = {"", ".uncertainty"};

/// A NaN counts as less than any number.
Real larger(const Real& a, const Real& b) { return a > b || !isfinite(b) ? a : b; }

}  // namespace

StructureMetrics::StructureMetrics(const std::vector<std::string>& patterns) : patterns_(patterns) {
    for (const Metric& metric : metrics())
        if (metric.of_structure && any_matches(patterns_, metric.description.name, suffixes_of_structures))
            entries_.push_back({&metric, {}});
}

void StructureMetrics::observe(const ObservedStep& at) {
    for (auto& [metric, worst] : entries_) {
        StepDefect found = metric->of_structure(at);
        worst.value = larger(worst.value, found.value);
        worst.uncertainty = larger(worst.uncertainty, found.uncertainty);
        if (worst.why_not.empty()) worst.why_not = std::move(found.why_not);
    }
}

void StructureMetrics::decline(const std::string& why_not) {
    for (auto& [metric, worst] : entries_) worst.why_not = why_not;
}

void StructureMetrics::report(MeasuredMetrics& all, std::map<std::string, std::string>& unmeasured) const {
    for (const auto& [metric, worst] : entries_) {
        const std::string& name = metric->description.name;
        if (!isfinite(worst.uncertainty)) unmeasured[name] = worst.why_not;
        if (worst.value > 10 * worst.uncertainty) add_measured(all, patterns_, name, worst.value);
        add_measured(all, patterns_, name + ".uncertainty", worst.uncertainty);
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
