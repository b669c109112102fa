// SPDX-License-Identifier: BSD-3-Clause
//
// How far the references of a convergence study can be trusted: one row per problem (by label) and end time, with the
// horizon, and for each quantity the digits up to which step sizes and routes agree, -log10 of the error bound relative
// to the size of the final state.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plots/tables/table.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

std::vector<std::string> metrics_of(const Results& results) {
    // Most mechanisms know nothing of torques: a column only where there are some.
    const auto occurs = [&](const std::string& metric) {
        return std::any_of(results.rows.begin(), results.rows.end(),
                           [&](const ResultRow& row) { return row.reference_error.contains(metric); });
    };
    std::vector<std::string> metrics;
    for (const MetricDescription& entry : metric_catalogue()) {
        const std::string &metric = entry.name, largest = entry.name + largest_of_error;
        if (is_error(entry) && (entry.rows != MetricRows::directions || occurs(metric))) { metrics.push_back(metric); }
        if (is_error(entry) && occurs(largest)) { metrics.push_back(largest); }
    }
    return metrics;
}

std::string digits(const ResultRow& row, const std::string& metric) {
    const auto bound = row.reference_error.find(metric);
    const auto scale = row.scale.find(metric);
    if (bound == row.reference_error.end() || scale == row.scale.end()) { return "-"; }
    if (bound->second == 0) { return "exact"; }
    return fmt::format("{:.1f}", -std::log10(bound->second / scale->second));
}

TextTable references_table(const Results& results) {
    const std::vector<std::string> metrics = metrics_of(results);
    TextTable table{"references", "References: " + results.name, {"problem", "t [s]", "horizon [s]"}, {}};
    table.notes = {
        "Digits up to which two step sizes and two independent routes agree at the end, and of .max at all samples, "
        "relative to the size of the final state; \"exact\" where they are equal. An asterisk marks a horizon that "
        "ends before t."};
    for (const std::string& metric : metrics) { table.columns.push_back(metric.substr(metric.find('.') + 1)); }
    std::map<std::pair<std::string, double>, std::size_t> lines;
    for (const ResultRow& row : results.rows) {
        if (!row.ok() || row.reference_error.empty()) { continue; }
        const auto [line, fresh] = lines.insert({{row.label, row.t_end}, table.rows.size()});
        if (fresh) {
            table.rows.push_back({row.label, fmt::format("{}", row.t_end),
                                  fmt::format("{:.4g}{}", row.reference_horizon, row.past_horizon ? "*" : "")});
            table.rows.back().resize(table.columns.size(), "-");
        }
        auto& cells = table.rows[line->second];
        for (std::size_t i = 0; i < metrics.size(); ++i) {  // a formulation without constraints has no multipliers
            std::string& cell = cells[cells.size() - metrics.size() + i];
            cell = cell == "-" ? digits(row, metrics[i]) : cell;
        }
    }
    return table;
}

std::vector<TablePair> references_tables(const Results& results) { return one_table(references_table(results)); }

}  // namespace

KREISEL_TABLE({.name = "references",
               .summary = "horizon of each reference, and the digits on which its routes agree",
               .place = 20,
               .applies = has_errors,
               .is_printed = never,
               .make = references_tables});

}  // namespace kreisel
