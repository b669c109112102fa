// SPDX-License-Identifier: BSD-3-Clause
//
// The largest energy error so far at the largest step of each method, with the law that all of its steps follow.
#include "plots/laws/energy.hpp"
#include "records/reading/trajectory_table.hpp"

#include <algorithm>

#include "plots/figures/cells/select.hpp"
#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kinds/curve_kind.hpp"

namespace kreisel {

namespace {

const ResultRow* coarsest_with_samples(const CellGroup& group) {
    const ResultRow* found = nullptr;
    for (const ResultRow* row : group.rows) {
        if (row->ok() && row->has_trajectory && (found == nullptr || row->h > found->h)) { found = row; }
    }
    return found;
}

class EnergyFigure final : public CurveKind {
  public:
    EnergyFigure() : CurveKind({"invariant.energy"}) {}

  private:
    std::vector<ResultRow> rows_of(const FigureSpec& of, const Results& results) const override {
        return selected_rows(of, results);
    }
    std::vector<CellGroup> groups_of(const std::vector<ResultRow>& rows) const override {
        return group_by_method(rows);
    }
    std::optional<Panel> empty_panel(const std::string& metric, const Units& units) const override {
        return Panel{"", "t [s]", metric_label(metric, units), true, true, {}, {}, {}};
    }
    std::optional<DrawnCurve> curve(const CellGroup& group, const std::string& metric) const override {
        const auto law = energy_law_of(group);
        const ResultRow* row = coarsest_with_samples(group);
        if (!law || row == nullptr) { return std::nullopt; }
        const TrajectoryTable samples = read_trajectory(*row);
        const auto *t = samples.find("t"), *largest = samples.find(metric + ".max");
        if (t == nullptr || largest == nullptr) { return std::nullopt; }
        return DrawnCurve{zipped(*t, *largest), ": " + enhanced_law(*law)};
    }
    static std::string enhanced_law(const EnergyLaw& law) {
        std::string text = energy_text(law);
        for (std::size_t at = text.find('^'); at != std::string::npos; at = text.find('^', at + 2)) {
            const std::size_t end = std::min(text.find(',', at), text.size());
            text = text.substr(0, at) + "^{" + text.substr(at + 1, end - at - 1) + "}" + text.substr(end);
        }
        return text;
    }
    std::string lacking() const override { return "energy errors with samples at two step sizes"; }
};

}  // namespace

KREISEL_FIGURE(EnergyFigure,
               {.name = "energy",
                .summary = "energy errors over time at the largest step, with the laws that all steps follow",
                .draws = FigureData::samples,
                .script = "lines",
                .keys = layout_keys()});

}  // namespace kreisel
