// SPDX-License-Identifier: BSD-3-Clause
//
// Errors against the step size, with the observed order of each curve in the legend and slope triangles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kinds/curve_kind.hpp"
#include "plots/figures/kinds/slope_triangle.hpp"
#include "plots/figures/select.hpp"
#include "plots/laws/convergence.hpp"

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

class ConvergenceFigure final : public CurveKind {
  public:
    ConvergenceFigure() : CurveKind({"error.position"}) {}

  private:
    std::vector<ResultRow> rows_of(const Results& results) const override {
        return selected_rows(*this, results, true);
    }
    std::vector<CellGroup> groups_of(const std::vector<ResultRow>& rows) const override {
        return group_by_method(rows);
    }
    std::optional<Panel> empty_panel(const std::string& metric, const Units& units) const override {
        return Panel{"", "h [s]", metric_label(metric, units), true, true, {}, {}, {}};
    }
    std::optional<DrawnCurve> curve(const CellGroup& group, const std::string& metric,
                                    const std::filesystem::path& /*folder*/) const override {
        const ObservedOrder order = order_of(group, metric);
        const auto some = [&](bool (*is)(const ResultRow*)) {
            return std::any_of(group.rows.begin(), group.rows.end(), is);
        };
        const bool failed = !some([](const ResultRow* row) { return row->ok(); });
        if (order.points.empty() && !failed) { return std::nullopt; }
        const bool past = some([](const ResultRow* row) { return row->past_horizon; });
        DrawnCurve drawn;
        drawn.remark = ": " + (failed ? enhanced_escape(group.front().status)
                                      : order_remark(order) + (past ? ", past the horizon" : ""));
        for (const ErrorPoint& point : order.points) { drawn.points.push_back({point.h, point.error}); }
        return drawn;
    }
    // One triangle for each whole order, below the lowest of its curves, where there is space.
    void complete(Panel& panel, const std::vector<CellGroup>& drawn, const std::string& metric) const override {
        for (const auto& [order, window] : lowest_windows(drawn, metric)) {
            const SlopeTriangle triangle = slope_triangle(window, order);
            panel.guides.push_back(triangle.outline);
            panel.marks.push_back(triangle.order);
        }
    }
    std::string lacking() const override { return "such error"; }
};

}  // namespace

KREISEL_FIGURE(ConvergenceFigure, {.name = "convergence",
                                   .summary = "errors against the step size, with observed orders",
                                   .script = "linespoints",
                                   .keys = curve_keys("error.")});

}  // namespace kreisel
