// SPDX-License-Identifier: BSD-3-Clause
//
// Least squares on straight lines.
#pragma once

#include <optional>
#include <vector>

namespace kreisel {

/// y = intercept + slope x, with the standard error of the slope (0 for two points).
struct Line {
    double slope = 0, intercept = 0, slope_error = 0;
};

/// Least squares with equal weights [gsl]. Throws std::invalid_argument unless there are two points with different x and
/// a y for each x.
Line fit_line(const std::vector<double>& x, const std::vector<double>& y);

/// y = coefficient t^exponent, fitted to log y against log t.
struct GrowthLaw {
    double exponent = 0, error = 0, coefficient = 0;
    double from = 0, to = 0;  ///< s; the range that was fitted
};

/// The growth law over the second half of the time span, which leaves the transient out. Nothing where fewer than four
/// positive values lie there, or where all of `y` stays at or below `floor` (round-off grows by no law worth a name).
std::optional<GrowthLaw> fit_growth(const std::vector<double>& t, const std::vector<double>& y, double floor);

}  // namespace kreisel
