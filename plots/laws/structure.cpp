// SPDX-License-Identifier: BSD-3-Clause
#include "plots/laws/structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plots/laws/abscissa.hpp"
#include "records/fits/fit.hpp"

namespace kreisel {

namespace {

constexpr int steps_for_kept = 3;

// The points come coarsest first.
void fit_structure(StructureLaw& law, std::vector<WorkPoint> points) {
    if (points.size() > 3) { points.erase(points.begin(), points.end() - 3); }
    if (points.size() < 2) { return; }
    std::vector<double> x, y;
    for (const WorkPoint& point : points) { x.push_back(std::log(point.x)), y.push_back(std::log(point.error)); }
    const double slope = fit_line(x, y).slope;
    for (std::size_t i = 1; i < x.size(); ++i) {
        law.spread = std::max(law.spread, std::abs((y[i] - y[i - 1]) / (x[i] - x[i - 1]) - slope));
    }
    if (law.spread < 0.25) { law.order = slope; }
}

}  // namespace

StructureLaw structure_of(const CellGroup& group, const std::string& metric) {
    StructureLaw law;
    for (const ResultRow* row : group.rows) {
        if (const auto reason = row->unmeasured->find(metric); reason != row->unmeasured->end()) {
            law.why_not = reason->second;
        }
        const auto uncertainty = row->metrics.find(metric + ".uncertainty");
        if (!row->ok() || uncertainty == row->metrics.end()) { continue; }
        ++law.steps;
        law.uncertainty = std::max(law.uncertainty, uncertainty->second);
    }
    const std::vector<WorkPoint> points = work_points(group, metric, "h");
    law.kept = points.empty() && law.steps >= steps_for_kept;
    if (!points.empty()) { law.largest = points.front().error; }
    fit_structure(law, points);
    return law;
}

std::string structure_text(const StructureLaw& law) {
    if (law.kept) { return "kept"; }
    if (law.order) { return fmt::format("h^{:.2f}", *law.order); }
    if (law.largest > 0) { return "changed"; }
    return law.steps > 0 ? "not seen" : "-";
}

}  // namespace kreisel
