// SPDX-License-Identifier: BSD-3-Clause
#include "plots/laws/proportionality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plots/laws/abscissa.hpp"
#include "plots/laws/convergence.hpp"
#include "records/fits/fit.hpp"

namespace kreisel {

namespace {

// The rule that the header states.
struct ProportionalityRule {
    static constexpr double ceiling = 1e-2, floor_factor = 100, steps = 20, decades = 3, residual = 1;
    static constexpr std::size_t points = 4;
};

bool is_admissible_tolerance(const TolerancePoint& point, const OrderLimits& limits) {
    using Rule = ProportionalityRule;
    const double round_off = limits.epsilon * std::sqrt(point.steps) * limits.scale;
    return point.steps >= Rule::steps && point.error < Rule::ceiling * limits.scale &&
           point.error > Rule::floor_factor * std::max(limits.reference_error, round_off);
}

void fit_slope(Proportionality& result, const std::vector<TolerancePoint>& points) {
    using Rule = ProportionalityRule;
    std::vector<double> x, y;
    for (const TolerancePoint& point : points) {
        x.push_back(std::log10(point.tolerance));
        y.push_back(std::log10(point.error));
    }
    if (points.size() < Rule::points || x.front() - x.back() < Rule::decades * (1 - 1e-9)) {
        result.reason = fmt::format("{} admissible tolerances, {} over {} decades are needed", points.size(),
                                    Rule::points, Rule::decades);
        return;
    }
    const FittedLine line = fit_line(x, y);
    double residual = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        residual = std::max(residual, std::abs(y[i] - line.intercept - line.slope * x[i]));
    }
    if (residual > Rule::residual) {
        result.reason =
            fmt::format("no power law: an error is a factor of {:.0f} from the line", std::pow(10, residual));
        return;
    }
    result.slope = line.slope;
    result.uncertainty = line.slope_error;
    result.from = points.front().tolerance;
    result.to = points.back().tolerance;
}

}  // namespace

Proportionality proportionality_of(const CellGroup& group, const std::string& metric) {
    Proportionality result;
    const OrderLimits limits = limits_of(group, metric);
    std::vector<TolerancePoint> admissible;
    for (const WorkPoint& point : work_points(group, metric, "tolerance")) {
        result.points.push_back({point.x, point.error, abscissa_of(*point.row, "accepted").value_or(0)});
        if (is_admissible_tolerance(result.points.back(), limits)) { admissible.push_back(result.points.back()); }
    }
    fit_slope(result, admissible);
    return result;
}

}  // namespace kreisel
