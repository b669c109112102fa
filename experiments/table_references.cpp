// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/table_references.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace kreisel {

namespace {

const std::vector<std::string> metrics = {"error.position", "error.rotation", "error.velocity", "error.omega",
                                          "error.multipliers"};

std::string digits(const ResultRow& row, const std::string& metric) {
    const auto bound = row.reference_error.find(metric);
    const auto scale = row.scale.find(metric);
    if (bound == row.reference_error.end() || scale == row.scale.end()) { return "-"; }
    if (bound->second == 0) { return "exact"; }
    return fmt::format("{:.1f}", -std::log10(bound->second / scale->second));
}

}  // namespace

TextTable references_table(const Results& results) {
    TextTable table{"references", "References: " + results.name, {"problem", "t [s]", "horizon [s]"}, {}};
    table.notes = {
        "Digits up to which two step sizes and two independent routes agree at the end, relative to the size of the "
        "final state; \"exact\" where they are equal."};
    for (const std::string& metric : metrics) { table.columns.push_back(metric.substr(metric.find('.') + 1)); }
    std::set<std::pair<std::string, double>> seen;
    for (const ResultRow& row : results.rows) {
        if (!row.ok() || row.reference_error.empty() || !seen.insert({row.label, row.t_end}).second) { continue; }
        table.rows.push_back({row.label, fmt::format("{}", row.t_end), fmt::format("{:.4g}", row.reference_horizon)});
        for (const std::string& metric : metrics) { table.rows.back().push_back(digits(row, metric)); }
    }
    return table;
}

}  // namespace kreisel
