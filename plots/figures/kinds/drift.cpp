// SPDX-License-Identifier: BSD-3-Clause
//
// Running maxima of defects against time or cost, with fitted growth laws.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plots/figures/kinds/sample_kind.hpp"
#include "plots/laws/abscissa.hpp"
#include "plots/laws/growth.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

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

double largest_of(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values) { largest = std::isfinite(value) ? std::max(largest, value) : largest; }
    return largest;
}

class DriftFigure final : public SampleKind {
  public:
    DriftFigure() : SampleKind({"defect.position", "defect.velocity"}) {}

  private:
    std::optional<Panel> empty_panel(const std::string& metric, const Units& units) const override {
        return Panel{"", abscissa_label(x), metric_label(metric, units), true, true, {}, {}, {}};
    }
    std::optional<DrawnCurve> curve(const CellGroup& group, const std::string& metric) const override {
        const ResultRow& row = group.front();
        const TrajectoryTable trajectory = read_trajectory(row);
        DrawnCurve drawn{maxima(trajectory, row, metric), ": " + end_text(row)};
        if (drawn.points.empty()) { return std::nullopt; }
        if (!row.ok()) { return drawn; }
        // Growth is over time, whatever the curve is drawn against.
        const auto law = growth_of(trajectory, metric, row.precision);
        const double roundoff = roundoff_level(trajectory, row.precision);
        drawn.remark = ": " + growth_text(law, largest_of(*trajectory.find(metric + ".max")), roundoff);
        if (law && x == "t") { drawn.guide = growth_line(*law); }
        return drawn;
    }
    std::string lacking() const override {
        return "such defect: where there are no constraints, the figure {\"kind\": \"invariants\"} shows first "
               "integrals";
    }
};

}  // namespace

KREISEL_FIGURE(DriftFigure, {.name = "drift",
                             .summary = "running maxima of defects against time or cost, with fitted growth laws",
                             .draws = FigureData::samples,
                             .script = "lines",
                             .keys = sample_keys("defect."),
                             .otherwise = "invariants"});

}  // namespace kreisel
