// SPDX-License-Identifier: BSD-3-Clause
#include "engine/metrics/metric.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::vector<Metric>& registry() {
    static std::vector<Metric> all;
    return all;
}

void enter(MetricDescription description, MetricKind kind, Metric metric) {
    description.kind = kind;
    metric.description = std::move(description);
    registry().push_back(std::move(metric));
}

auto order_of(const Metric& metric) {
    return std::tie(metric.description.kind, metric.description.place, metric.description.name);
}

std::vector<Metric> sorted_metrics() {
    auto all = registry();
    std::sort(all.begin(), all.end(), [](const Metric& a, const Metric& b) { return order_of(a) < order_of(b); });
    for (const Metric& metric : all) {
        const auto same = [&](const Metric& other) { return other.description.name == metric.description.name; };
        if (std::count_if(all.begin(), all.end(), same) > 1)
            throw std::logic_error("two metrics are named \"" + metric.description.name + "\"");
    }
    return all;
}

}  // namespace

MetricRegistration::MetricRegistration(MetricDescription description, ObserveStep observe) {
    enter(std::move(description), MetricKind::defect, {.description = {}, .of_step = observe});
}
MetricRegistration::MetricRegistration(MetricDescription description, ObserveSeparation observe) {
    enter(std::move(description), MetricKind::error, {.description = {}, .of_separation = observe});
}
MetricRegistration::MetricRegistration(MetricDescription description, ObserveComparison observe) {
    enter(std::move(description), MetricKind::error, {.description = {}, .of_comparison = observe});
}

const std::vector<Metric>& metrics() {
    static const std::vector<Metric> all = sorted_metrics();
    return all;
}

bool occurs(MetricRows kind, const std::vector<ConstraintRow>& rows) {
    if (kind == MetricRows::any) return true;
    return std::any_of(rows.begin(), rows.end(),
                       [&](const ConstraintRow& row) { return row.direction == (kind == MetricRows::directions); });
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
