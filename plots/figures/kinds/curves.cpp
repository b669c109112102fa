// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plots/tables/drift.hpp"
#include "plots/tables/orders.hpp"
#include "plots/tables/scaling.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

// The panels of a figure: a facet value (or none) and a metric each.
struct PanelKey {
    std::string facet, metric;
};

std::vector<std::string> facet_values(const FigureSpec& spec, const CellNames& names,
                                      const std::vector<ResultRow>& rows) {
    std::vector<std::string> values;
    for (const ResultRow& row : rows) {
        const std::string value = spec.facet.empty() ? "" : names.axis(row, spec.facet);
        if (std::find(values.begin(), values.end(), value) == values.end()) { values.push_back(value); }
    }
    return values;
}

std::vector<PanelKey> panel_keys(const FigureSpec& spec, const CellNames& names, const std::vector<ResultRow>& rows) {
    std::vector<PanelKey> keys;
    for (const std::string& facet : facet_values(spec, names, rows)) {
        for (const std::string& metric : spec.metrics) { keys.push_back({facet, metric}); }
    }
    return keys;
}

bool in_panel(const FigureSpec& spec, const CellNames& names, const ResultRow& row, const PanelKey& key) {
    return spec.facet.empty() || names.axis(row, spec.facet) == key.facet;
}

std::vector<std::string> legend_axes(const FigureSpec& spec, const CellNames& names) {
    return names.varying_axes(spec.facet.empty() ? std::vector<std::string>{} : std::vector<std::string>{spec.facet});
}

// Gives the same style to the same legend in every panel.
class Styles {
  public:
    int of(const std::string& label) {
        return styles_.insert({label, static_cast<int>(styles_.size()) + 1}).first->second;
    }

  private:
    std::map<std::string, int> styles_;
};

PanelFigure empty_figure(const FigureSpec& spec) {
    return {spec.kind, spec.name, enhanced_escape(spec.title), {}, spec.columns};
}

std::string facet_title(const FigureSpec& spec, const PanelKey& key) {
    return key.facet == "none" && spec.facet == "projection" ? "no projection" : enhanced_escape(key.facet);
}

std::string order_text(const ObservedOrder& order) {
    if (order.order) { return fmt::format("{:.2f} ± {:.2f}", *order.order, order.uncertainty); }
    switch (order.why) {
        case NoOrder::pre_asymptotic:
            return "pre-asymptotic";
        case NoOrder::round_off:
            return order.last > order.first ? "too few points above round-off" : "floor";
        case NoOrder::not_settled:
            return "not settled";
        case NoOrder::not_convergent:
            return "no convergence";
        default:
            return "too few points";
    }
}

std::vector<Point> window_points(const ObservedOrder& order) {
    std::vector<Point> points;
    for (std::size_t i = order.first; i <= order.last; ++i) {
        points.push_back({order.points[i].h, order.points[i].error});
    }
    return points;
}

// One triangle for each whole order, below the lowest of its curves, where there is space.
void add_triangles(Panel& panel, const std::vector<ObservedOrder>& orders) {
    std::map<int, std::vector<Point>> lowest;
    for (const ObservedOrder& order : orders) {
        if (!order.order) { continue; }
        const int rounded = static_cast<int>(std::lround(*order.order));
        if (rounded < 1 || std::abs(*order.order - rounded) > 0.25) { continue; }
        const auto window = window_points(order);
        const auto height = [&](const Point& point) { return point.y / std::pow(point.x, rounded); };
        auto& best = lowest[rounded];
        if (best.empty() || height(window.back()) < height(best.back())) { best = window; }
    }
    for (const auto& [rounded, window] : lowest) {
        const SlopeTriangle triangle = slope_triangle(window, rounded);
        panel.guides.push_back(triangle.outline);
        panel.marks.push_back(triangle.order);
    }
}

std::vector<Point> growth_line(const GrowthLaw& law) {
    const auto at = [&](double t) { return Point{t, law.coefficient * std::pow(t, law.exponent)}; };
    return {at(law.from), at(law.to)};
}

std::string growth_text(const std::optional<GrowthLaw>& law, double largest, double roundoff) {
    if (largest == 0) { return "zero"; }
    if (law && std::abs(law->exponent) < 0.005) { return "constant"; }
    if (law) { return fmt::format("∝ t^{{{:.2f} ± {:.2f}}}", law->exponent, law->spread); }
    return largest <= roundoff ? "round-off" : "no growth law";
}

std::string scaling_text(const std::optional<ScalingLaw>& law) {
    return law ? fmt::format(": ∝ N^{{{:.3f} ± {:.3f}}}", law->exponent, law->error) : "";
}

std::vector<Point> scaling_line(const ScalingLaw& law) {
    const auto at = [&](long n) {
        const auto bodies = static_cast<double>(n);
        return Point{bodies, law.coefficient * std::pow(bodies, law.exponent)};
    };
    return {at(law.from), at(law.to)};
}

std::vector<Point> zipped(const std::vector<double>& x, const std::vector<double>& y, double factor = 1) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < x.size(); ++i) { points.push_back({x[i], factor * y[i]}); }
    return points;
}

double largest_of(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values) { largest = std::isfinite(value) ? std::max(largest, value) : largest; }
    return largest;
}

// The legend of a row for trajectories: with step counts if they vary.
std::string trajectory_legend(const CellNames& names, const std::vector<std::string>& axes, const ResultRow& row,
                              bool steps_vary) {
    std::string text = axes.empty() && steps_vary ? "" : names.legend(row, axes);
    if (steps_vary) { text += fmt::format("{}h = {:.3g} s", text.empty() ? "" : ", ", row.h); }
    return text;
}

// Why a cell did not finish; its samples are drawn up to there.
std::string end_text(const ResultRow& row) {
    return enhanced_escape(row.status) + fmt::format(" at {:.3g} s", row.t_reached);
}

bool steps_vary(const std::vector<ResultRow>& rows) {
    return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.steps != rows.front().steps; });
}

}  // namespace

SlopeTriangle slope_triangle(const std::vector<Point>& window, int order) {
    const std::size_t middle = (window.size() - 1) / 2;
    const Point coarse = window[middle], fine = window[middle + 1];
    const double drop = std::pow(10.0, -0.35);
    const double base = fine.y * drop, tip = base * std::pow(coarse.x / fine.x, order);
    SlopeTriangle triangle{{{fine.x, base}, {coarse.x, base}, {coarse.x, tip}, {fine.x, base}}, {}};
    triangle.order = {{coarse.x * 1.22, std::sqrt(base * tip)}, fmt::format("{}", order)};
    return triangle;
}

std::string metric_label(const std::string& metric, const Units& units) {
    static const std::map<std::string, std::string> integrals = {
        {"invariant.energy", "max |E − E_0|"}, {"invariant.angular_momentum_vertical", "max |L_z − L_{z,0}|"}};
    const auto integral = integrals.find(metric);
    const MetricDescription* entry = find_metric(metric);
    const std::string symbol = integral != integrals.end()                 ? integral->second
                               : entry != nullptr && entry->name == metric ? entry->symbol
                                                                           : enhanced_escape(metric);
    const std::string unit = metric_unit(metric, units);
    return symbol + (unit.empty() || unit == "1" ? "" : " [" + enhanced_escape(unit) + "]");
}

PanelFigure convergence_figure(const FigureSpec& spec, const Results& results) {
    const auto rows = selected_rows(spec, results, true);
    const CellNames names(rows);
    const auto axes = legend_axes(spec, names);
    Styles styles;
    PanelFigure figure = empty_figure(spec);
    for (const PanelKey& key : panel_keys(spec, names, rows)) {
        Panel panel{facet_title(spec, key), "h [s]", metric_label(key.metric, results.units), true, true, {}, {}, {}};
        std::vector<ObservedOrder> orders;
        for (const CellGroup& group : group_by_method(rows)) {
            if (!in_panel(spec, names, group.front(), key)) { continue; }
            const ObservedOrder order = order_of(group, key.metric);
            const bool failed =
                std::none_of(group.rows.begin(), group.rows.end(), [](const auto* row) { return row->ok(); });
            if (order.points.empty() && !failed) { continue; }
            const std::string label = names.legend(group.front(), axes);
            const bool past =
                std::any_of(group.rows.begin(), group.rows.end(), [](const auto* row) { return row->past_horizon; });
            const std::string remark =
                failed ? enhanced_escape(group.front().status) : order_text(order) + (past ? ", past the horizon" : "");
            Curve curve{enhanced_escape(label) + ": " + remark, {}, styles.of(label)};
            for (const ErrorPoint& point : order.points) { curve.points.push_back({point.h, point.error}); }
            panel.curves.push_back(std::move(curve));
            orders.push_back(order);
        }
        add_triangles(panel, orders);
        if (!panel.curves.empty()) { figure.panels.push_back(std::move(panel)); }
    }
    if (figure.panels.empty()) {
        throw FigureError(fmt::format("{}: the selected cells hold no such error", spec.name));
    }
    return figure;
}

PanelFigure drift_figure(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder) {
    const auto rows = with_samples(selected_rows(spec, results, true), spec);
    const CellNames names(rows);
    const auto axes = legend_axes(spec, names);
    Styles styles;
    PanelFigure figure = empty_figure(spec);
    for (const PanelKey& key : panel_keys(spec, names, rows)) {
        Panel panel{facet_title(spec, key), "t [s]", metric_label(key.metric, results.units), true, true, {}, {}, {}};
        for (const ResultRow& row : rows) {
            if (!in_panel(spec, names, row, key)) { continue; }
            const TrajectoryTable trajectory = read_trajectory(folder, row);
            const auto* values = trajectory.find(key.metric + ".max");
            const auto* t = trajectory.find("t");
            if (values == nullptr || t == nullptr) { continue; }
            const auto law = growth_of(trajectory, key.metric, row.precision);
            const std::string label = trajectory_legend(names, axes, row, steps_vary(rows));
            const std::string growth =
                row.ok() ? growth_text(law, largest_of(*values), roundoff_level(trajectory, row.precision))
                         : end_text(row);
            panel.curves.push_back({enhanced_escape(label) + ": " + growth, zipped(*t, *values), styles.of(label)});
            if (law && row.ok()) { panel.guides.push_back(growth_line(*law)); }
        }
        if (!panel.curves.empty()) { figure.panels.push_back(std::move(panel)); }
    }
    if (figure.panels.empty()) {
        throw FigureError(fmt::format("{}: the selected cells hold no such defect", spec.name));
    }
    return figure;
}

PanelFigure invariants_figure(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder) {
    const auto rows = with_samples(selected_rows(spec, results, true), spec);
    const CellNames names(rows);
    const auto axes = legend_axes(spec, names);
    Styles styles;
    PanelFigure figure = empty_figure(spec);
    for (const PanelKey& key : panel_keys(spec, names, rows)) {
        const std::string label_y = spec.relative ? enhanced_escape(key.metric.substr(10)) + ": max |I − I_0| / |I_0|"
                                                  : metric_label(key.metric, results.units);
        Panel panel{facet_title(spec, key), "t [s]", label_y, false, true, {}, {}, {}};
        for (const ResultRow& row : rows) {
            const auto largest = row.metrics.find(key.metric), relative = row.metrics.find(key.metric + ".relative");
            const bool known = largest != row.metrics.end() && (!spec.relative || relative != row.metrics.end());
            if (!in_panel(spec, names, row, key) || !known || largest->second == 0) { continue; }
            const TrajectoryTable trajectory = read_trajectory(folder, row);
            const auto* values = trajectory.find(key.metric + ".max");
            const auto* t = trajectory.find("t");
            if (values == nullptr || t == nullptr) { continue; }
            const double factor = spec.relative ? relative->second / largest->second : 1;
            const std::string label = trajectory_legend(names, axes, row, steps_vary(rows));
            const std::string remark = row.ok() ? "" : ": " + end_text(row);
            panel.curves.push_back({enhanced_escape(label) + remark, zipped(*t, *values, factor), styles.of(label)});
        }
        if (!panel.curves.empty()) { figure.panels.push_back(std::move(panel)); }
    }
    if (figure.panels.empty()) {
        throw FigureError(fmt::format("{}: the selected cells hold no such invariant", spec.name));
    }
    return figure;
}

PanelFigure scaling_figure(const FigureSpec& spec, const Results& results) {
    const auto rows = by_series(selected_rows(spec, results));
    const CellNames names(rows);
    const auto axes = legend_axes(spec, names);
    const auto curves = scaling_curves(rows);
    Styles styles;
    PanelFigure figure = empty_figure(spec);
    for (const PanelKey& key : panel_keys(spec, names, rows)) {
        const auto& quantities = scaling_quantities();
        const auto quantity = std::find_if(quantities.begin(), quantities.end(),
                                           [&](const ScalingQuantity& one) { return one.name == key.metric; });
        if (quantity == quantities.end()) { continue; }
        Panel panel{
            facet_title(spec, key), "number of bodies N", quantity->label, true, !quantity->per_body, {}, {}, {},
            quantity->per_body};
        for (const CellGroup& group : curves) {
            if (!in_panel(spec, names, group.front(), key)) { continue; }
            // A curve per body shows by itself whether it is constant, on an axis that starts at zero.
            const auto law = quantity->per_body ? std::nullopt : scaling_law(group, key.metric);
            const std::string label = names.legend(group.front(), axes);
            Curve curve{enhanced_escape(label) + scaling_text(law), {}, styles.of(label)};
            for (const ResultRow* row : group.rows) {
                if (const auto value = scaling_value(*row, key.metric)) {
                    curve.points.push_back({static_cast<double>(row->bodies), *value / quantity->unit});
                }
            }
            if (curve.points.empty()) { continue; }
            if (law) { panel.guides.push_back(scaling_line(*law)); }
            panel.curves.push_back(std::move(curve));
        }
        if (!panel.curves.empty()) { figure.panels.push_back(std::move(panel)); }
    }
    if (figure.panels.empty()) {
        throw FigureError(
            fmt::format("{}: the selected cells hold no such cost; the times stand in the journals beside "
                        "the results",
                        spec.name));
    }
    return figure;
}

namespace {

struct Component {
    std::string label, unit;
    const std::vector<double>* values;
};

// Of a vector of a body, or of all multipliers: forces, then torques.
std::vector<Component> components_of(const std::string& prefix, const std::string& symbol,
                                     const TrajectoryTable& trajectory) {
    std::vector<Component> all;
    for (std::size_t i = 0; i < trajectory.names.size(); ++i) {
        const std::string& name = trajectory.names[i];
        if (!name.starts_with(prefix)) { continue; }
        const std::string index = enhanced_escape(name.substr(prefix.size()));
        const std::string label =
            index.size() > 1 ? fmt::format("{}_{{{}}}", symbol, index) : fmt::format("{}_{}", symbol, index);
        all.push_back({label, trajectory.units[i], &trajectory.columns[i]});
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.unit < b.unit; });
    return all;
}

}  // namespace

PanelFigure components_figure(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder) {
    static const std::map<std::string, std::string> symbols = {
        {"x", "x"}, {"v", "v"}, {"omega", "ω"}, {"multipliers", "λ"}};
    const TrajectoryTable trajectory = selected_samples(spec, selected_trajectory(spec, results), folder);
    const auto* t = trajectory.find("t");
    const std::string& symbol = symbols.at(spec.quantity);
    const bool multipliers = spec.quantity == "multipliers";
    const std::string prefix = multipliers ? "lambda." : body_of(spec, trajectory) + "." + spec.quantity;
    const auto components = components_of(prefix, symbol, trajectory);
    if (t == nullptr || components.empty()) {
        throw FigureError(fmt::format("{}: the trajectory has no columns {}{}, ...", spec.name, prefix,
                                      multipliers ? "JOINT.1" : "1"));
    }
    PanelFigure figure = empty_figure(spec);
    if (spec.stacked) { figure.axes_height = 2.2; }
    std::string unit;
    for (const Component& component : components) {
        if (spec.stacked || figure.panels.empty() || component.unit != unit) {
            const std::string& name = spec.stacked ? component.label : symbol;
            unit = component.unit;
            if (!figure.panels.empty() && spec.columns == 1) { figure.panels.back().x_label.clear(); }
            figure.panels.push_back({"", "t [s]", fmt::format("{} [{}]", name, unit), false, false, {}, {}, {}});
        }
        auto& curves = figure.panels.back().curves;
        curves.push_back({spec.stacked ? "" : component.label, zipped(*t, *component.values),
                          spec.stacked ? 1 : static_cast<int>(curves.size()) + 1});
    }
    return figure;
}

}  // namespace kreisel
