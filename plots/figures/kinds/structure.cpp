// SPDX-License-Identifier: BSD-3-Clause
//
// Defects of single steps against the step size, with their observed orders.
#include "plots/laws/structure.hpp"

#include <fmt/format.h>

#include "plots/figures/cells/select.hpp"
#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kinds/curve_kind.hpp"
#include "plots/laws/abscissa.hpp"

namespace kreisel {

namespace {

class StructureFigure final : public CurveKind {
  public:
    StructureFigure() : CurveKind({"structure.symplectic", "structure.reversal"}) {}

  private:
    std::vector<ResultRow> rows_of(const FigureSpec& of, const Results& results) const override {
        return selected_rows(of, results, true);
    }
    std::vector<CellGroup> groups_of(const std::vector<ResultRow>& rows) const override {
        return group_by_method(rows);
    }
    std::optional<Panel> empty_panel(const std::string& metric, const Units& units) const override {
        return Panel{"", abscissa_label("h"), metric_label(metric, units), true, true, {}, {}, {}};
    }
    std::optional<DrawnCurve> curve(const CellGroup& group, const std::string& metric) const override {
        const StructureLaw law = structure_of(group, metric);
        if (law.steps == 0) { return std::nullopt; }
        DrawnCurve drawn;
        for (const WorkPoint& point : work_points(group, metric, "h")) {
            drawn.points.push_back({point.x, point.error});
        }
        drawn.remark = ": " + (law.order ? fmt::format("h^{{{:.2f}}}", *law.order) : structure_text(law));
        return drawn;
    }
    std::string lacking() const override { return "defects of steps"; }
};

}  // namespace

KREISEL_FIGURE(StructureFigure, {.name = "structure",
                                 .summary = "defects of single steps against the step size, with observed orders",
                                 .script = "linespoints",
                                 .keys = curve_keys({"structure."})});

}  // namespace kreisel
