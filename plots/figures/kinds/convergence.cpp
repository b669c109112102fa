// SPDX-License-Identifier: BSD-3-Clause
//
// Errors against the step size, the tolerance or the cost, with the observed order or tolerance proportionality of each
// curve in the legend, and slope triangles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plots/figures/cells/select.hpp"
#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kinds/abscissa_value.hpp"
#include "plots/figures/kinds/curve_kind.hpp"
#include "plots/figures/kinds/slope_triangle.hpp"
#include "plots/laws/convergence.hpp"
#include "plots/laws/proportionality.hpp"

namespace kreisel {

namespace {

std::string order_remark(const ObservedOrder& order) {
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

// For each whole order the window of its lowest curve.
std::map<int, std::vector<Point>> lowest_windows(const std::vector<CellGroup>& groups, const std::string& metric) {
    std::map<int, std::vector<Point>> lowest;
    for (const CellGroup& group : groups) {
        const ObservedOrder order = order_of(group, metric);
        if (!order.order) { continue; }
        const int rounded = static_cast<int>(std::lround(*order.order));
        if (rounded < 1 || std::abs(*order.order - rounded) > 0.25) { continue; }
        const auto window = window_points(order);
        const auto height = [&](const Point& point) { return point.y / std::pow(point.x, rounded); };
        auto& best = lowest[rounded];
        if (best.empty() || height(window.back()) < height(best.back())) { best = window; }
    }
    return lowest;
}

std::string proportionality_remark(const Proportionality& law) {
    if (!law.slope) { return "no proportionality"; }
    return fmt::format("∝ tolerance^{{{:.2f} ± {:.2f}}}", *law.slope, law.uncertainty);
}

class ConvergenceFigure final : public CurveKind {
  public:
    ConvergenceFigure() : CurveKind({"error.position"}) {}

    std::string x;  ///< empty: the step size, or the tolerance where steps are chosen to one

    std::string drawn_against() const override { return x; }

  private:
    std::string x_of(const CellGroup& group) const { return !x.empty() ? x : is_adaptive(group) ? "tolerance" : "h"; }
    std::vector<ResultRow> rows_of(const FigureSpec& of, const Results& results) const override {
        return selected_rows(of, results, true);
    }
    std::vector<CellGroup> groups_of(const std::vector<ResultRow>& rows) const override {
        return group_by_method(rows);
    }
    std::optional<Panel> empty_panel(const std::string& metric, const Units& units) const override {
        return Panel{"", abscissa_label(x.empty() ? "h" : x), metric_label(metric, units), true, true, {}, {}, {}};
    }
    std::optional<DrawnCurve> curve(const CellGroup& group, const std::string& metric) const override {
        const std::vector<WorkPoint> points = work_points(group, metric, x_of(group));
        const auto some = [&](bool (*is)(const ResultRow*)) {
            return std::any_of(group.rows.begin(), group.rows.end(), is);
        };
        const bool failed = !some([](const ResultRow* row) { return row->ok(); });
        if (points.empty() && !failed) { return std::nullopt; }
        const bool past = some([](const ResultRow* row) { return row->past_horizon; });
        DrawnCurve drawn;
        const auto law = [&] {
            return is_adaptive(group) ? proportionality_remark(proportionality_of(group, metric))
                                      : order_remark(order_of(group, metric));
        };
        drawn.remark =
            ": " + (failed ? enhanced_escape(group.front().status) : law() + (past ? ", past the horizon" : ""));
        for (const WorkPoint& point : points) { drawn.points.push_back({point.x, point.error}); }
        const ObservedOrder order = order_of(group, metric);
        if (x_of(group) == "h" && order.order && !failed) { drawn.fitted = window_points(order); }
        return drawn;
    }
    // One triangle for each whole order, below the lowest of its curves, where there is space.
    void complete(Panel& panel, const std::vector<CellGroup>& drawn, const std::string& metric) const override {
        const auto adaptive = std::count_if(drawn.begin(), drawn.end(), is_adaptive);
        if (x.empty() && adaptive > 0) {
            const bool all = adaptive == std::ssize(drawn);
            panel.x_label = all ? abscissa_label("tolerance") : abscissa_label("h") + ", or tolerance";
        }
        if (!x.empty() && x != "h") { return; }
        for (const auto& [order, window] : lowest_windows(drawn, metric)) {
            const SlopeTriangle triangle = slope_triangle(window, order);
            panel.guides.push_back(triangle.outline);
            panel.marks.push_back(triangle.order);
        }
    }
    std::string lacking() const override { return "such error"; }
};

std::vector<FigureKey> convergence_keys() {
    auto keys = curve_keys({"error."});
    keys.push_back(figure_key("x", &ConvergenceFigure::x, abscissa_value(), "what errors are drawn against",
                              "h, or tolerance where steps are chosen to one"));
    return keys;
}

}  // namespace

KREISEL_FIGURE(ConvergenceFigure, {.name = "convergence",
                                   .summary = "errors against step size, tolerance or cost, with observed orders",
                                   .script = "linespoints",
                                   .keys = convergence_keys()});

}  // namespace kreisel
