// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

const std::vector<std::string> order_notes = {
    "Observed order: least-squares slope of log error against log h over the window of step counts in brackets, +- the "
    "largest distance of a local slope from it. Admissible errors lie below 1e-2 of the scale, above 100 times the "
    "error "
    "of the reference and above 100 eps sqrt(N) of the scale; at least three consecutive slopes must agree."};

std::vector<std::string> with(std::vector<std::string> head, const std::vector<std::string>& tail) {
    head.insert(head.end(), tail.begin(), tail.end());
    return head;
}

double value_or_nan(const std::map<std::string, double>& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? absent : found->second;
}

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

std::string window(const ObservedOrder& order) {
    return fmt::format("{}–{}", order.points[order.first].steps, order.points[order.last].steps);
}

std::string order_cell(const ObservedOrder& order) {
    if (!order.order) { return order.points.empty() ? "-" : in_short(order.why); }
    return fmt::format("{:.2f} ± {:.2f} [{}]", *order.order, order.uncertainty, window(order));
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

const ResultRow* finest(const CellGroup& group) {
    const ResultRow* best = nullptr;
    for (const ResultRow* row : group.rows) {
        if (row->ok() && (best == nullptr || row->steps > best->steps)) { best = row; }
    }
    return best;
}

std::vector<std::string> errors_row(const ResultRow& row, const std::vector<std::string>& metrics,
                                    std::string (*number)(double)) {
    std::vector<std::string> cells = {fmt::format("{}", row.steps), number(row.h)};
    for (const std::string& metric : metrics) { cells.push_back(number(value_or_nan(row.metrics, metric))); }
    return cells;
}

// Marks the errors of a row that ends past the horizon of its reference; the first two cells are not errors.
std::vector<std::string> marked(std::vector<std::string> cells, const ResultRow& row) {
    for (std::size_t i = 2; i < cells.size() && row.past_horizon; ++i) { cells[i] += cells[i] == "-" ? "" : "*"; }
    return cells;
}

std::vector<std::string> with_units(const std::vector<std::string>& metrics, const Units& units) {
    std::vector<std::string> titles;
    titles.reserve(metrics.size());
    for (const std::string& metric : metrics) {
        titles.push_back(fmt::format("{} [{}]", metric, metric_unit(metric, units)));
    }
    return titles;
}

// "4", or "2, 2, 1": configuration, velocity, multipliers.
std::string declared_cell(const ResultRow& row) {
    if (row.declared_order.empty()) { return "-"; }
    const auto of = [&](MetricLevel level) { return row.declared_order.at(metric_of(level)); };
    const int q = of(MetricLevel::configuration), v = of(MetricLevel::velocity), lambda = of(MetricLevel::multipliers);
    return q == v && v == lambda ? fmt::format("{}", q) : fmt::format("{}, {}, {}", q, v, lambda);
}

std::vector<std::string> without_prefix(const std::vector<std::string>& metrics) {
    std::vector<std::string> titles;
    titles.reserve(metrics.size());
    for (const std::string& metric : metrics) { titles.push_back(metric.substr(metric.find('.') + 1)); }
    return titles;
}

}  // namespace

ObservedOrder order_of(const CellGroup& group, const std::string& metric) {
    std::vector<ErrorPoint> points;
    OrderLimits limits;
    limits.epsilon = epsilon_of(group.front().precision);
    for (const ResultRow* row : group.rows) {
        const auto error = row->metrics.find(metric);
        if (!row->ok() || error == row->metrics.end()) { continue; }
        points.push_back({row->steps, row->h, error->second});
        const auto bound = row->reference_error.find(metric);
        if (bound != row->reference_error.end()) {
            limits.reference_error = std::max(limits.reference_error, bound->second);
        }
    }
    if (const ResultRow* best = finest(group)) {
        const auto scale = best->scale.find(metric);
        if (scale != best->scale.end()) { limits.scale = scale->second; }
    }
    return observed_order(std::move(points), limits);
}

std::vector<std::string> error_metrics(const std::vector<ResultRow>& rows) {
    std::vector<std::string> found;
    for (const MetricDescription& entry : metric_catalogue()) {
        const std::string& metric = entry.name;
        const bool occurs = is_error(entry) && std::any_of(rows.begin(), rows.end(), [&](const auto& row) {
                                return row.metrics.contains(metric);
                            });
        if (occurs) { found.push_back(metric); }
    }
    return found;
}

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
            const auto found = row.declared_order.find(metric);
            const std::string declared = found == row.declared_order.end() ? "" : fmt::format("{}", found->second);
            table.rows.push_back(with(with(identity(names, row), {metric, declared}), full_row(order)));
        }
    }
    return table;
}

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

TextTable errors_in_full(const Results& results) {
    const CellNames names(results.rows);
    const auto metrics = error_metrics(results.rows);
    TextTable table{"errors", "Errors of the final state: " + results.name, {}, {}};
    table.columns =
        with(with(with(CellNames::axes(), {"steps", "h [s]"}), with_units(metrics, results.units)), {"past_horizon"});
    for (const CellGroup& group : group_by_method(results.rows)) {
        for (const ResultRow* row : group.rows) {
            if (!row->ok()) { continue; }
            table.rows.push_back(with(identity(names, *row), errors_row(*row, metrics, exact_number)));
            table.rows.back().emplace_back(row->past_horizon ? "yes" : "");
        }
    }
    return table;
}

TextTable errors_in_brief(const Results& results) {
    const CellNames names(results.rows);
    const auto metrics = error_metrics(results.rows);
    TextTable table{"errors", "Errors of the final state, finest step: " + results.name, {}, {}};
    bool past = false;
    table.columns = with(with(CellNames::axes(), {"steps", "h [s]"}), with_units(metrics, results.units));
    for (const CellGroup& group : group_by_method(results.rows)) {
        const ResultRow* best = finest(group);
        if (best == nullptr) { continue; }
        table.rows.push_back(with(identity(names, *best), marked(errors_row(*best, metrics, short_number), *best)));
        past = past || best->past_horizon;
    }
    if (past) {
        table.notes.emplace_back(
            "An asterisk marks errors past the horizon of the reference: they are above 100 times its uncertainty.");
    }
    return without_constant_columns(table, with(CellNames::axes(), {"steps", "h [s]"}));
}

}  // namespace kreisel
