// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/sample_kind.hpp"

#include <fmt/format.h>

#include "plots/figures/cells/select.hpp"
#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kinds/abscissa_value.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

std::vector<ResultRow> SampleKind::rows_of(const FigureSpec& of, const Results& results) const {
    return with_samples(selected_rows(of, results, true), of);
}

std::vector<CellGroup> SampleKind::groups_of(const std::vector<ResultRow>& rows) const {
    std::vector<CellGroup> groups;
    for (const ResultRow& row : rows) { groups.push_back({{&row}}); }
    return groups;
}

std::vector<Point> SampleKind::maxima(const TrajectoryTable& samples, const ResultRow& row, const std::string& metric,
                                      double factor) const {
    const auto at = abscissa_of_samples(samples, row, x);
    const auto* values = samples.find(metric + ".max");
    return at && values != nullptr ? zipped(*at, *values, factor) : std::vector<Point>();
}

std::vector<FigureKey> sample_keys(const std::string& family) {
    auto keys = curve_keys({family});
    keys.push_back(figure_key("x", &SampleKind::x, abscissa_value(times_and_costs()),
                              "what they are drawn against: time or, in an experiment of kind work_precision, cost"));
    return keys;
}

std::string end_text(const ResultRow& row) {
    return enhanced_escape(row.status) + fmt::format(" at {:.3g} s", row.t_reached);
}

}  // namespace kreisel
