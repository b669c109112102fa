// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "driver/plan/metric_names.hpp"
#include "records/json/diagnostics.hpp"
#include "records/metrics/catalogue.hpp"
#include "support/nearest.hpp"
#include "support/pattern.hpp"

namespace kreisel {

namespace {

// Whether there are rows of the kind that a metric is of.
bool has_rows_of(const ConstraintSummary& constraints, MetricRows rows) {
    switch (rows) {
        case MetricRows::any:
            return true;
        case MetricRows::lengths:
            return constraints.rows > constraints.directions;
        case MetricRows::directions:
            return constraints.directions > 0;
    }
    return false;
}

// Whether some cell can measure a metric: metrics of constraints need constraints, those of multipliers unique ones,
// and maxima over samples need samples.
bool can_be_measured(const Plan& plan, const std::string& name) {
    const MetricDescription* metric = find_metric(name);
    if (is_largest_error(name) && plan.config.samples == 0) { return false; }
    const auto& systems = plan.systems.kinds();
    return std::any_of(systems.begin(), systems.end(), [&](const PlannedSystems::Shared& shared) {
        const SystemSummary& system = *shared;
        if (!system.skip_reason.empty()) { return false; }
        if (metric == nullptr) {
            const auto names = metric_names(names_of(system.integrals));
            return std::find(names.begin(), names.end(), name) != names.end();
        }
        if (metric->level == MetricLevel::multipliers && system.constraints.has_redundant_rows()) { return false; }
        return has_rows_of(system.constraints, metric->rows);
    });
}

bool is_plain(const std::string& pattern) { return pattern.find('*') == std::string::npos; }

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> measurable_among(const std::vector<std::string>& names, const Plan& plan) {
    std::vector<std::string> measurable;
    std::copy_if(names.begin(), names.end(), std::back_inserter(measurable),
                 [&](const std::string& name) { return can_be_measured(plan, name); });
    return measurable;
}

// Names, and the patterns of whole groups that fit some of them.
std::vector<std::string> with_groups(std::vector<std::string> names) {
    const std::size_t count = names.size();
    for (const char* group : {"error.*", "defect.*", "structure.*", "invariant.*"}) {
        const auto end = names.begin() + static_cast<std::ptrdiff_t>(count);
        const bool fits = std::any_of(names.begin(), end, [&](const auto& name) { return matches(group, name); });
        if (fits) { names.emplace_back(group); }
    }
    return names;
}

}  // namespace

std::vector<std::string> known_metrics(const Plan& plan) {
    std::set<std::string> integrals;
    for (const PlannedSystems::Shared& system : plan.systems.kinds()) {
        for (const IntegralDescription& integral : system->integrals) { integrals.insert(integral.name); }
    }
    return metric_names({integrals.begin(), integrals.end()});
}

std::vector<std::string> unknown_metrics(const std::vector<std::string>& names, const Config& config) {
    std::vector<std::string> unknown;
    if (!config.metrics_given) { return unknown; }
    for (const std::string& name : config.metrics) {
        if (is_plain(name) && !contains(names, name)) { unknown.push_back(name); }
    }
    return unknown;
}

void check_metrics(const std::vector<std::string>& names, const std::vector<std::string>& taken, Diagnostics& sink,
                   Plan& plan) {
    if (!plan.config.metrics_given) { return; }
    for (std::size_t i = 0; i < plan.config.metrics.size(); ++i) {
        const std::string& pattern = plan.config.metrics[i];
        const std::string pointer = fmt::format("/metrics/{}", i);
        const auto fits = [&](const std::string& name) { return matches(pattern, name); };
        if (contains(taken, pattern)) {
            plan.warnings.push_back(fmt::format("{}: {} is left out: --filter took the problems that have it away",
                                                pointer, in_quotes(pattern)));
        } else if (is_plain(pattern) && !contains(names, pattern)) {
            sink.add({.pointer = pointer,
                      .expected = "a metric of these problems, or a pattern that fits one (see kreisel list metrics)",
                      .got = in_quotes(pattern),
                      .suggestion = nearest_name(pattern, names),
                      .rule = Rule::metric});
        } else if (std::none_of(names.begin(), names.end(),
                                [&](const std::string& name) { return fits(name) && can_be_measured(plan, name); })) {
            const std::string nearest =
                is_plain(pattern) ? "" : nearest_name(pattern, with_groups(measurable_among(names, plan)));
            plan.warnings.push_back(fmt::format("{}: {} fits no metric that a cell of this config can measure{}",
                                                pointer, in_quotes(pattern),
                                                nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?"));
        }
    }
    std::erase_if(plan.config.metrics, [&](const std::string& name) { return contains(taken, name); });
}

}  // namespace kreisel
