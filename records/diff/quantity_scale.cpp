// SPDX-License-Identifier: BSD-3-Clause
#include "records/diff/quantity_scale.hpp"

#include <algorithm>
#include <cmath>

#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

constexpr std::string_view invariant = "invariant.";

std::string without(const std::string& name, std::string_view suffix) {
    return name.ends_with(suffix) ? name.substr(0, name.size() - suffix.size()) : name;
}

/// "energy" of "invariant.energy.slope".
std::string integral_of(const std::string& metric) {
    std::string name = metric.substr(invariant.size());
    for (const char* suffix : {".final", ".relative", ".slope", ".slope_error"}) { name = without(name, suffix); }
    return name;
}

}  // namespace

QuantityScales::QuantityScales(const RecordedCell& a, const RecordedCell& b) {
    add(a);
    add(b);
}

void QuantityScales::add(const RecordedCell& cell) {
    for (const auto& [name, quantity] : cell.final_state) {
        double& scale = of_family_[quantity.family];
        scale = std::max(scale, std::fabs(quantity.number.value));
    }
    for (const auto& [name, quantity] : cell.metrics) {
        if (!name.starts_with(invariant) || !name.ends_with(".relative")) { continue; }
        const std::string integral = integral_of(name);
        const auto deviation = cell.metrics.find(std::string(invariant) + integral);
        const double relative = quantity.number.value;
        if (deviation == cell.metrics.end() || !(relative > 0)) { continue; }
        double& initial = initial_[integral];
        initial = std::max(initial, deviation->second.number.value / relative);
    }
    if (cell.t_end > 0) { rate_ = std::max(rate_, 1 / cell.t_end); }
}

double QuantityScales::of_state(const std::string& family) const {
    const auto found = of_family_.find(family);
    return found == of_family_.end() ? 0 : found->second;
}

double QuantityScales::of_invariant(const std::string& name) const {
    if (name.ends_with(".relative")) { return 1; }
    const auto found = initial_.find(integral_of(name));
    if (found == initial_.end()) { return 0; }
    return name.ends_with(".slope") || name.ends_with(".slope_error") ? found->second * rate_ : found->second;
}

double QuantityScales::of(MetricScale scale) const {
    const double x = of_state("final.x"), v = of_state("final.v"), w = of_state("final.omega");
    switch (scale) {
        case MetricScale::own:
            return 0;
        case MetricScale::one:
            return 1;
        case MetricScale::position:
            return x;
        case MetricScale::velocity:
            return v;
        case MetricScale::omega:
            return w;
        case MetricScale::force:
            return of_state("final.multipliers [N]");
        case MetricScale::torque:
            return of_state("final.multipliers [N m]");
        case MetricScale::acceleration:
            return v * (w + rate_);
        case MetricScale::angular_acceleration:
            return w * (w + rate_);
    }
    return 0;
}

double QuantityScales::of_metric(const std::string& name, double own) const {
    if (name.starts_with(invariant)) { return std::max(own, of_invariant(name)); }
    const MetricDescription* metric = find_metric(name);
    return metric == nullptr ? own : std::max(own, of(metric->scale));
}

}  // namespace kreisel
