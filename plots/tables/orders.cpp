// SPDX-License-Identifier: BSD-3-Clause
//
// Observed orders of a convergence study.
#include <fmt/format.h>

#include <cmath>

#include "plots/laws/convergence.hpp"
#include "plots/tables/cells.hpp"
#include "plots/tables/table.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

const std::vector<std::string> order_notes = {
    "Observed order: least-squares slope of log error against log h over the window of step counts in brackets, +- the "
    "largest distance of a local slope from it. Admissible errors lie below 1e-2 of the scale, above 100 times the "
    "error "
    "of the reference and above 100 eps sqrt(N) of the scale; at least three consecutive slopes must agree."};

std::string in_short(NoOrder why) {
    switch (why) {
        case NoOrder::none:
            return "";
        case NoOrder::too_few_points:
            return "too few points";
        case NoOrder::round_off:
            return "floor";
        case NoOrder::pre_asymptotic:
            return "pre-asymptotic";
        case NoOrder::not_settled:
            return "not settled";
        case NoOrder::not_convergent:
            return "no convergence";
    }
    return "";
}

std::string window_text(const ObservedOrder& order) {
    return fmt::format("{}–{}", order.points[order.first].steps, order.points[order.last].steps);
}

std::string order_cell(const ObservedOrder& order) {
    if (!order.order) { return order.points.empty() ? "-" : in_short(order.why); }
    return fmt::format("{:.2f} ± {:.2f} [{}]", *order.order, order.uncertainty, window_text(order));
}

std::string slopes_text(const ObservedOrder& order) {
    std::string text;
    for (const double slope : order.slopes) {
        text += (text.empty() ? "" : " ") + (std::isnan(slope) ? std::string("-") : fmt::format("{:.3f}", slope));
    }
    return text;
}

std::vector<std::string> full_row(const ObservedOrder& order) {
    if (!order.order) { return {"", "", "", "", "least squares", slopes_text(order), order.reason}; }
    return {fmt::format("{:.4f}", *order.order),
            fmt::format("{:.4f}", order.uncertainty),
            fmt::format("{}", order.points[order.first].steps),
            fmt::format("{}", order.points[order.last].steps),
            "least squares",
            slopes_text(order),
            order.stall ? fmt::format("stalls at {:.1e}", *order.stall) : ""};
}

// "4", or "2, 2, 1": configuration, velocity, multipliers.
std::string declared_cell(const ResultRow& row) {
    if (row.declared_order->empty()) { return "-"; }
    const auto of = [&](MetricLevel level) { return row.declared_order->at(metric_of(level)); };
    const int q = of(MetricLevel::configuration), v = of(MetricLevel::velocity), lambda = of(MetricLevel::multipliers);
    return q == v && v == lambda ? fmt::format("{}", q) : fmt::format("{}, {}, {}", q, v, lambda);
}

std::vector<std::string> without_prefix(const std::vector<std::string>& metrics) {
    std::vector<std::string> titles;
    titles.reserve(metrics.size());
    for (const std::string& metric : metrics) { titles.push_back(metric.substr(metric.find('.') + 1)); }
    return titles;
}

// One row per group and metric, with window, slopes and reason.
TextTable orders_in_full(const Results& results) {
    const CellNames names(results.rows);
    TextTable table{"orders", "Observed orders: " + results.name, {}, {}};
    table.columns = with(CellNames::axes(), {"metric", "declared", "order", "uncertainty", "first_steps", "last_steps",
                                             "estimator", "slopes", "remark"});
    for (const CellGroup& group : group_by_method(results.rows)) {
        const ResultRow& row = group.front();
        for (const std::string& metric : error_metrics(results.rows)) {
            const ObservedOrder order = order_of(group, metric);
            if (order.points.empty()) { continue; }
            const auto found = row.declared_order->find(metric);
            const std::string declared = found == row.declared_order->end() ? "" : fmt::format("{}", found->second);
            table.rows.push_back(with(with(identity(names, row), {metric, declared}), full_row(order)));
        }
    }
    return table;
}

// One row per group, one column per metric: "3.99 ± 0.02 [256–4096]", or the reason in short.
TextTable orders_in_brief(const Results& results) {
    const CellNames names(results.rows);
    const auto metrics = error_metrics(results.rows);
    TextTable table{"orders", "Observed orders: " + results.name, {}, {}, order_notes};
    table.columns = with(with(CellNames::axes(), {"declared"}), without_prefix(metrics));
    for (const CellGroup& group : group_by_method(results.rows)) {
        std::vector<std::string> cells = {declared_cell(group.front())};
        bool any = false;
        for (const std::string& metric : metrics) {
            const ObservedOrder order = order_of(group, metric);
            any = any || !order.points.empty();
            cells.push_back(order_cell(order));
        }
        if (any) { table.rows.push_back(with(identity(names, group.front()), cells)); }
    }
    return without_constant_columns(table, CellNames::axes());
}

std::vector<TablePair> orders_tables(const Results& results) {
    return one_table(orders_in_full(results), orders_in_brief(results));
}

}  // namespace

KREISEL_TABLE({.name = "orders",
               .summary = "observed orders with their windows, or why there is none",
               .place = 30,
               .applies = has_errors,
               .is_printed = always,
               .make = orders_tables});

}  // namespace kreisel
