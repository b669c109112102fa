// SPDX-License-Identifier: BSD-3-Clause
#include "engine/metrics/metric.hpp"

#include <algorithm>

#include "support/registered.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// By kind, then by place.
int place_of(MetricKind kind, int place) {
    constexpr int places_of_a_kind = 1000000;
    return static_cast<int>(kind) * places_of_a_kind + place;
}

void enter(MetricDescription description, MetricKind kind, Metric metric) {
    description.kind = kind;
    metric.place = place_of(kind, description.place);
    metric.description = std::move(description);
    Registered<Metric>::add(std::move(metric));
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

MetricRegistration::MetricRegistration(MetricDescription description, ObserveStructure observe) {
    enter(std::move(description), MetricKind::structure, {.description = {}, .of_structure = observe});
}

const std::vector<Metric>& metrics() { return Registered<Metric>::all(); }

bool occurs(MetricRows kind, const std::vector<ConstraintRow>& rows) {
    if (kind == MetricRows::any) return true;
    return std::any_of(rows.begin(), rows.end(),
                       [&](const ConstraintRow& row) { return row.direction == (kind == MetricRows::directions); });
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
