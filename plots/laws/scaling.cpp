// SPDX-License-Identifier: BSD-3-Clause
#include "plots/laws/scaling.hpp"

#include <algorithm>
#include <cmath>

#include "records/fits/fit.hpp"

namespace kreisel {

const std::vector<ScalingQuantity>& scaling_quantities() {
    static const std::vector<ScalingQuantity> all = {
        {"cost.step", "CPU time per step [s]"},
        {"cost.step_per_body", "CPU time per step and body [ns]", 1e-9, true},
        {"cost.memory", "memory [bytes]"},
        {"cost.memory_per_body", "memory per body [kB]", 1e3, true}};
    return all;
}

std::optional<double> scaling_value(const ResultRow& row, const std::string& quantity) {
    const bool time = quantity.starts_with("cost.step");
    const auto found = row.cost.find(time ? "step_s" : "memory");
    if (found == row.cost.end() || row.bodies <= 0) { return std::nullopt; }
    return quantity.ends_with("_per_body") ? found->second / static_cast<double>(row.bodies) : found->second;
}

std::vector<ResultRow> by_series(std::vector<ResultRow> rows) {
    for (ResultRow& row : rows) { row.label = row.series; }
    return rows;
}

std::vector<CellGroup> scaling_curves(const std::vector<ResultRow>& rows) {
    std::vector<CellGroup> curves = grouped(rows, [](const ResultRow& a, const ResultRow& b) {
        return same_but_for_size(a, b) && a.steps == b.steps && a.tolerance == b.tolerance;
    });
    for (CellGroup& curve : curves) {
        std::stable_sort(curve.rows.begin(), curve.rows.end(),
                         [](const ResultRow* a, const ResultRow* b) { return a->bodies < b->bodies; });
    }
    return curves;
}

std::optional<ScalingLaw> scaling_law(const CellGroup& curve, const std::string& quantity) {
    std::vector<double> x, y;
    ScalingLaw law;
    int sizes = 0;
    for (const ResultRow* row : curve.rows) {
        const auto value = scaling_value(*row, quantity);
        if (row->bodies < least_bodies || !value || !(*value > 0)) { continue; }
        if (x.empty()) { law.from = row->bodies; }
        if (row->bodies != law.to) { ++sizes; }
        law.to = row->bodies;
        x.push_back(std::log(static_cast<double>(row->bodies)));
        y.push_back(std::log(*value));
    }
    if (sizes < 3) { return std::nullopt; }
    const FittedLine line = fit_line(x, y);
    law.exponent = line.slope;
    law.error = line.slope_error;
    law.coefficient = std::exp(line.intercept);
    return law;
}

}  // namespace kreisel
