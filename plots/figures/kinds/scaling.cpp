// SPDX-License-Identifier: BSD-3-Clause
//
// Time and memory of a step against the number of bodies, with the exponent of each curve in the legend.
#include "plots/laws/scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plots/figures/cells/select.hpp"
#include "plots/figures/kinds/curve_kind.hpp"

namespace kreisel {

namespace {

const ScalingQuantity* find_quantity(const std::string& name) {
    const auto& all = scaling_quantities();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> quantity_names() {
    std::vector<std::string> names;
    for (const ScalingQuantity& quantity : scaling_quantities()) { names.push_back(quantity.name); }
    return names;
}

std::vector<Point> scaling_line(const ScalingLaw& law) {
    const auto at = [&](long n) {
        const auto bodies = static_cast<double>(n);
        return Point{bodies, law.coefficient * std::pow(bodies, law.exponent)};
    };
    return {at(law.from), at(law.to)};
}

class ScalingFigure final : public CurveKind {
  public:
    ScalingFigure() : CurveKind({"cost.step", "cost.memory"}) {}

  private:
    std::vector<ResultRow> rows_of(const FigureSpec& of, const Results& results) const override {
        return by_series(selected_rows(of, results));
    }
    std::vector<CellGroup> groups_of(const std::vector<ResultRow>& rows) const override { return scaling_curves(rows); }
    std::optional<Panel> empty_panel(const std::string& metric, const Units& /*units*/) const override {
        const ScalingQuantity* quantity = find_quantity(metric);
        if (quantity == nullptr) { return std::nullopt; }
        const bool per_body = quantity->per_body;
        return Panel{"", "number of bodies N", quantity->label, true, !per_body, {}, {}, {}, per_body};
    }
    std::optional<DrawnCurve> curve(const CellGroup& group, const std::string& metric) const override {
        const ScalingQuantity& quantity = *find_quantity(metric);
        DrawnCurve drawn;
        for (const ResultRow* row : group.rows) {
            if (const auto value = scaling_value(*row, metric)) {
                drawn.points.push_back({static_cast<double>(row->bodies), *value / quantity.unit});
            }
        }
        if (drawn.points.empty()) { return std::nullopt; }
        // A curve per body shows by itself whether it is constant, on an axis that starts at zero.
        if (const auto law = quantity.per_body ? std::nullopt : scaling_law(group, metric)) {
            drawn.remark = fmt::format(": ∝ N^{{{:.3f} ± {:.3f}}}", law->exponent, law->error);
            drawn.guide = scaling_line(*law);
        }
        return drawn;
    }
    std::string lacking() const override { return "such cost; the times stand in the journals beside the results"; }
};

}  // namespace

KREISEL_FIGURE(ScalingFigure, {.name = "scaling",
                               .summary = "time and memory of a step against the number of bodies, with exponents",
                               .draws = FigureData::timed_cells,
                               .script = "linespoints",
                               .keys = curve_keys({"cost."}, quantity_names()),
                               .metrics = quantity_names()});

}  // namespace kreisel
