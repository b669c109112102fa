// SPDX-License-Identifier: BSD-3-Clause
//
// Running maxima of |I - I0|, or of |I - I0|/|I0|, against time or cost.
#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kinds/sample_kind.hpp"
#include "plots/laws/abscissa.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

const std::string invariant_family = "invariant.";

class InvariantsFigure final : public SampleKind {
  public:
    InvariantsFigure() : SampleKind({invariant_family + "energy"}) {}

    bool relative = false;

  private:
    std::optional<Panel> empty_panel(const std::string& metric, const Units& units) const override {
        const std::string label =
            relative ? enhanced_escape(metric.substr(invariant_family.size())) + ": max |I − I_0| / |I_0|"
                     : metric_label(metric, units);
        return Panel{"", abscissa_label(x), label, false, true, {}, {}, {}};
    }
    std::optional<DrawnCurve> curve(const CellGroup& group, const std::string& metric) const override {
        const ResultRow& row = group.front();
        const auto largest = row.metrics.find(metric), by_size = row.metrics.find(metric + ".relative");
        const bool known = largest != row.metrics.end() && (!relative || by_size != row.metrics.end());
        if (!known || largest->second == 0) { return std::nullopt; }
        const double factor = relative ? by_size->second / largest->second : 1;
        const std::vector<Point> points = maxima(read_trajectory(row), row, metric, factor);
        if (points.empty()) { return std::nullopt; }
        return DrawnCurve{points, row.ok() ? "" : ": " + end_text(row)};
    }
    std::string lacking() const override { return "such invariant"; }
};

std::vector<FigureKey> invariants_keys() {
    auto keys = sample_keys(invariant_family);
    keys.push_back(figure_key("relative", &InvariantsFigure::relative, figure_value::flag(),
                              "whether to divide by the initial value"));
    return keys;
}

}  // namespace

KREISEL_FIGURE(InvariantsFigure, {.name = "invariants",
                                  .summary = "running maxima of the changes of first integrals against time or cost",
                                  .draws = FigureData::samples,
                                  .script = "lines",
                                  .keys = invariants_keys()});

}  // namespace kreisel
