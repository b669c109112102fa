// SPDX-License-Identifier: BSD-3-Clause
//
// Errors, defects and changes of first integrals against what they cost.
#include <fmt/format.h>

#include <algorithm>

#include "plots/figures/cells/select.hpp"
#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kinds/abscissa_value.hpp"
#include "plots/figures/kinds/curve_kind.hpp"

namespace kreisel {

namespace {

std::string steps_label(const ResultRow& row) {
    return row.adaptive() ? fmt::format("{:.0e}", row.tolerance) : fmt::format("{}", row.steps);
}

class WorkPrecisionFigure final : public CurveKind {
  public:
    WorkPrecisionFigure() : CurveKind({"error.position"}) {}

    std::string x = "evaluations";
    bool labels = false;

    std::string drawn_against() const override { return x; }

  private:
    std::vector<ResultRow> rows_of(const FigureSpec& of, const Results& results) const override {
        return selected_rows(of, results, true);
    }
    std::vector<CellGroup> groups_of(const std::vector<ResultRow>& rows) const override {
        return group_by_method(rows);
    }
    std::optional<Panel> empty_panel(const std::string& metric, const Units& units) const override {
        return Panel{"", abscissa_label(x), metric_label(metric, units), true, true, {}, {}, {}};
    }
    std::optional<DrawnCurve> curve(const CellGroup& group, const std::string& metric) const override {
        const auto ran = [](const ResultRow* row) { return row->ok(); };
        const bool failed = std::none_of(group.rows.begin(), group.rows.end(), ran);
        DrawnCurve drawn;
        for (const WorkPoint& point : work_points(group, metric, x)) { drawn.points.push_back({point.x, point.error}); }
        if (drawn.points.empty() && !failed) { return std::nullopt; }
        if (failed) { drawn.remark = ": " + enhanced_escape(group.front().status); }
        return drawn;
    }
    // The steps or the tolerance above each point.
    void complete(Panel& panel, const std::vector<CellGroup>& drawn, const std::string& metric) const override {
        constexpr double above = 2;
        for (const CellGroup& group : drawn) {
            for (const WorkPoint& point : work_points(group, metric, x)) {
                const bool visible = point.x > 0 && point.error > 0;
                if (labels && visible) {
                    panel.marks.push_back({{point.x, above * point.error}, steps_label(*point.row)});
                }
            }
        }
    }
    std::string lacking() const override { return "such metric and cost; CPU times stand in the journals"; }
};

std::vector<FigureKey> work_precision_keys() {
    auto keys = curve_keys({"error.", "defect.", "invariant."});
    keys.push_back(figure_key("x", &WorkPrecisionFigure::x, abscissa_value(), "the cost that they are drawn against"));
    keys.push_back(figure_key("labels", &WorkPrecisionFigure::labels, figure_value::flag(),
                              "whether points are labelled by their number of steps, or their tolerance"));
    return keys;
}

}  // namespace

KREISEL_FIGURE(WorkPrecisionFigure, {.name = "work_precision",
                                     .summary = "errors, defects or changes of first integrals against cost",
                                     .script = "linespoints",
                                     .keys = work_precision_keys()});

}  // namespace kreisel
