// SPDX-License-Identifier: BSD-3-Clause
#include "records/metrics/units.hpp"

#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

const std::string invariant_prefix = "invariant.";

bool remove_suffix(std::string& name, const std::string& suffix) {
    const bool ends = name.ends_with(suffix);
    if (ends) { name.resize(name.size() - suffix.size()); }
    return ends;
}

std::string per_second(const std::string& unit) {
    if (unit.empty()) { return ""; }
    if (unit == "J") { return "W"; }
    std::string rate = unit;
    return remove_suffix(rate, " s") ? rate : unit + "/s";
}

}  // namespace

Units units_of_metrics(const std::vector<IntegralDescription>& integrals) {
    Units units;
    for (const MetricDescription& metric : metric_catalogue()) { units[metric.name] = metric.unit; }
    for (const IntegralDescription& integral : integrals) {
        const auto [place, fresh] = units.insert({invariant_prefix + integral.name, integral.unit});
        if (!fresh && place->second != integral.unit) { place->second = ""; }
    }
    return units;
}

Units units_before_format_2(const std::vector<std::string>& metrics) {
    Units units;
    for (const std::string& metric : metrics) {
        if (!metric.starts_with(invariant_prefix)) { continue; }
        const std::string name = metric.substr(0, metric.find('.', invariant_prefix.size()));
        if (name == "invariant.energy") { units[name] = "J"; }
        if (name.find("momentum") != std::string::npos) {
            units[name] = name.starts_with("invariant.momentum_") ? "N s" : "N m s";
        }
    }
    return units;
}

std::string metric_unit(const std::string& metric, const Units& units) {
    std::string name = metric;
    if (remove_suffix(name, ".relative")) { return "1"; }
    const bool rate = remove_suffix(name, ".slope") || remove_suffix(name, ".slope_error");
    remove_suffix(name, ".final") || remove_suffix(name, ".max") || remove_suffix(name, ".uncertainty");
    if (const auto found = units.find(name); found != units.end()) {
        return rate ? per_second(found->second) : found->second;
    }
    const MetricDescription* known = find_metric(name);
    return known == nullptr ? "" : known->unit;
}

}  // namespace kreisel
