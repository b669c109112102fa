// SPDX-License-Identifier: BSD-3-Clause
//
// Distances from the reference at the times of samples, against time or cost.
#include "plots/figures/kinds/sample_kind.hpp"
#include "plots/laws/abscissa.hpp"
#include "records/metrics/catalogue.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

const std::string running_maximum = ".max";

std::string base_of(const std::string& metric) {
    return is_largest_error(metric) ? metric.substr(0, metric.size() - running_maximum.size()) : metric;
}

class ErrorsFigure final : public SampleKind {
  public:
    ErrorsFigure() : SampleKind({"error.position"}) {}

    /// What an experiment has to measure: errors at samples are taken for their maxima.
    std::vector<std::string> drawn_metrics() const override {
        std::vector<std::string> all;
        for (const std::string& metric : metrics) { all.push_back(base_of(metric) + running_maximum); }
        return all;
    }

  private:
    std::optional<Panel> empty_panel(const std::string& metric, const Units& units) const override {
        return Panel{"", abscissa_label(x), metric_label(metric, units), false, true, {}, {}, {}};
    }
    std::optional<DrawnCurve> curve(const CellGroup& group, const std::string& metric) const override {
        const ResultRow& row = group.front();
        const TrajectoryTable samples = read_trajectory(row);
        const auto at = abscissa_of_samples(samples, row, x);
        const auto* errors = samples.find(base_of(metric));
        if (!at || errors == nullptr) { return std::nullopt; }
        DrawnCurve drawn{zipped(*at, *errors), row.ok() ? "" : ": " + end_text(row)};
        if (is_largest_error(metric)) { take_maxima(drawn.points); }
        return drawn;
    }
    // The largest so far; where an error is not known, it enters none.
    static void take_maxima(std::vector<Point>& points) {
        double largest = 0;
        for (Point& point : points) { largest = point.y = point.y > largest ? point.y : largest; }
    }
    std::string lacking() const override {
        return "such errors at samples, which experiments have that measure \"error.*.max\", up to the horizon of "
               "their "
               "references";
    }
};

}  // namespace

KREISEL_FIGURE(ErrorsFigure, {.name = "errors",
                              .summary = "errors at the times of samples against time or cost",
                              .draws = FigureData::samples,
                              .script = "lines",
                              .keys = sample_keys("error.")});

}  // namespace kreisel
