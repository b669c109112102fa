// SPDX-License-Identifier: BSD-3-Clause
#include "records/metrics/catalogue.hpp"

#include <string_view>

namespace kreisel {

const std::vector<MetricDescription>& metric_catalogue() {
    static const std::vector<MetricDescription> all = engine_binary64().metrics();  // those of quad are the same
    return all;
}

const std::vector<std::string>& names_of_metrics() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const MetricDescription& metric : metric_catalogue()) {
            for (std::string& name : names_of_metric(metric)) { all.push_back(std::move(name)); }
        }
        return all;
    }();
    return names;
}

const MetricDescription* find_metric(const std::string& name) {
    std::string_view base = name;
    for (const std::string_view suffix : {".final", ".max", ".uncertainty"}) {
        if (base.ends_with(suffix)) { base.remove_suffix(suffix.size()); }
    }
    for (const MetricDescription& metric : metric_catalogue()) {
        if (metric.name == base) { return &metric; }
    }
    return nullptr;
}

bool is_largest_error(const std::string& name) {
    const MetricDescription* metric = find_metric(name);
    return metric != nullptr && is_error(*metric) && name == metric->name + largest_of_error;
}

std::string metric_of(MetricLevel level) {
    for (const MetricDescription& metric : metric_catalogue()) {
        if (metric.level == level) { return metric.name; }
    }
    return "";
}

}  // namespace kreisel
