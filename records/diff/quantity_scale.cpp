// SPDX-License-Identifier: BSD-3-Clause
#include "records/diff/quantity_scale.hpp"

#include <algorithm>
#include <cmath>

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

double QuantityScales::of_metric(const std::string& name, double own) const {
    if (name.starts_with(invariant)) { return std::max(own, of_invariant(name)); }
    const double x = of_state("final.x"), v = of_state("final.v"), w = of_state("final.omega");
    const std::map<std::string, double> scales = {
        {"error.position", x},
        {"error.velocity", v},
        {"error.omega", w},
        {"error.rotation", 1},
        {"error.multipliers", of_state("final.multipliers [N]")},
        {"error.multipliers.torque", of_state("final.multipliers [N m]")},
        {"defect.position", x},
        {"defect.velocity", v},
        {"defect.acceleration", v * (w + rate_)},
        {"defect.direction", 1},
        {"defect.direction.velocity", w},
        {"defect.direction.acceleration", w * (w + rate_)},
        {"defect.orthogonality", 1},
    };
    const auto found = scales.find(without(name, ".final"));
    return found == scales.end() ? own : std::max(own, found->second);
}

}  // namespace kreisel
