// SPDX-License-Identifier: BSD-3-Clause
//
// Declared against observed orders at a glance: one table for each problem (by label) of a convergence study, named
// "certification", or "certification_<label>" where there are several; a line per method, a column per formulation. A
// cell holds the observed orders of configuration, velocity and multipliers: the least over the metrics of each that
// have one, "-" where none does; "?" where the slopes of a metric have not settled; "!" where one does not converge, or
// its order and the finest local slope of its window fall short of the declared one by more than `order_tolerance`.
#include <fmt/format.h>

#include <algorithm>

#include "plots/laws/convergence.hpp"
#include "plots/tables/table.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

using Metrics = std::vector<std::string>;

constexpr MetricLevel levels[] = {MetricLevel::configuration, MetricLevel::velocity, MetricLevel::multipliers};

// How far an observed order may fall short of the declared one.
double order_tolerance(int declared) { return declared < 6 ? 0.1 : 0.2; }

// The claim is about h -> 0: if the slopes of the window still rise, the finest one counts.
bool falls_short(const ObservedOrder& order, int declared) {
    if (order.why == NoOrder::not_convergent) { return true; }
    const double least = declared - order_tolerance(declared);
    return order.order && *order.order < least && order.slopes[order.last - 1] < least;
}

// The least observed order over the metrics of a level, "?" if one of them has not settled, "!" if one falls short.
std::string level_text(const CellGroup& group, MetricLevel level) {
    std::optional<double> least;
    bool low = false, settled = true;
    for (const MetricDescription& entry : metric_catalogue()) {
        const std::string& metric = entry.name;
        const ObservedOrder order = entry.level == level ? order_of(group, metric) : ObservedOrder{};
        if (order.points.empty()) { continue; }
        if (order.order) { least = least ? std::min(*least, *order.order) : *order.order; }
        settled = settled && order.why != NoOrder::not_settled;
        const auto declared = group.front().declared_order->find(metric);
        low = low || (declared != group.front().declared_order->end() && falls_short(order, declared->second));
    }
    const std::string marks = std::string(settled ? "" : "?") + (low ? "!" : "");
    return (least ? fmt::format("{:.2f}", *least) : marks.empty() ? "-" : "") + marks;
}

std::string cell_text(const CellGroup& group) {
    const bool failed = std::none_of(group.rows.begin(), group.rows.end(), [](const auto* row) { return row->ok(); });
    if (failed) { return group.front().status; }
    std::string text;
    for (const MetricLevel level : levels) { text += (text.empty() ? "" : " / ") + level_text(group, level); }
    return text;
}

// The name of a line: the method and, if they vary, projection and precision.
std::string line_name(const CellNames& names, const Metrics& axes, const ResultRow& row) {
    std::string text = names.axis(row, "method");
    for (const std::string& axis : axes) {
        if (axis == "projection" || axis == "precision") { text += ", " + names.axis(row, axis); }
    }
    return text;
}

std::string declared_text(const ResultRow& row) {
    if (row.declared_order->empty()) { return "-"; }
    std::string text;
    for (const MetricLevel level : levels) {
        text += fmt::format("{}{}", text.empty() ? "" : " / ", row.declared_order->at(metric_of(level)));
    }
    return text;
}

// A valid file name for any label.
std::string file_name(const std::string& label, bool single) {
    if (single) { return "certification"; }
    std::string name = "certification_" + label;
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return std::string_view("abcdefghijklmnopqrstuvwxyz0123456789_").find(c) == std::string::npos; },
        '_');
    return name;
}

TextTable table_of(const std::string& label, bool single, const std::vector<CellGroup>& groups,
                   const CellNames& names) {
    TextTable table{file_name(label, single), "Declared and observed orders: " + label, {"method", "declared"}, {}};
    table.notes = {
        "Orders of configuration / velocity / multipliers, each the least over its metrics (position and rotation, "
        "velocity and omega) of which an order can be stated, \"-\" if there is none; \"?\" where the slopes of one "
        "have not settled, by itself if none has settled; \"!\" where one does not converge, or its order and the "
        "finest slope of its window fall short of "
        "the declared one by more than 0.1 (0.2 from order 6)."};
    const auto axes = names.varying_axes({});
    for (const CellGroup& group : groups) {
        const ResultRow& row = group.front();
        if (row.label != label || row.status == "skipped" || row.adaptive()) { continue; }
        const auto column = std::find(table.columns.begin(), table.columns.end(), row.formulation);
        const auto index = static_cast<std::size_t>(column - table.columns.begin());
        if (column == table.columns.end()) { table.columns.push_back(row.formulation); }
        const std::string name = line_name(names, axes, row);
        auto line = std::find_if(table.rows.begin(), table.rows.end(), [&](const auto& one) { return one[0] == name; });
        if (line == table.rows.end()) {
            table.rows.push_back({name, declared_text(row)});
            line = std::prev(table.rows.end());
        }
        line->resize(std::max(line->size(), index + 1), "-");
        (*line)[index] = cell_text(group);
    }
    for (auto& line : table.rows) { line.resize(table.columns.size(), "-"); }
    return table;
}

std::vector<TablePair> certification_tables(const Results& results) {
    const CellNames names(results.rows);
    const auto groups = group_by_method(results.rows);
    std::vector<std::string> labels;
    for (const CellGroup& group : groups) {
        const std::string& label = group.front().label;
        if (std::find(labels.begin(), labels.end(), label) == labels.end()) { labels.push_back(label); }
    }
    std::vector<TablePair> tables;
    tables.reserve(labels.size());
    for (const std::string& label : labels) {
        tables.push_back({.full = table_of(label, labels.size() == 1, groups, names)});
    }
    return tables;
}

}  // namespace

KREISEL_TABLE({.name = "certification",
               .summary = "declared and observed orders: a line per method, a column per formulation",
               .place = 10,
               .applies = has_errors,
               .is_printed = never,
               .make = certification_tables});

}  // namespace kreisel
