// SPDX-License-Identifier: BSD-3-Clause
//
// Least squares on straight lines.
#pragma once

#include <optional>
#include <vector>

namespace kreisel {

/// y = intercept + slope x, with the standard error of the slope (0 for two points).
struct FittedLine {
    double slope = 0, intercept = 0, slope_error = 0;
};

/// Least squares with equal weights [gsl]. Throws std::invalid_argument unless there are two points with different x
/// and a y for each x.
FittedLine fit_line(const std::vector<double>& x, const std::vector<double>& y);

/// y = coefficient t^exponent, fitted to log y against log t.
struct GrowthLaw {
    double exponent = 0, coefficient = 0;
    double spread = 0;        ///< largest distance of a local exponent, that of one octave, from `exponent`
    double from = 0, to = 0;  ///< s; the range that was fitted
};

/// The growth law over the last two octaves of time, [T/4, T], which leave the transient out. A running maximum is
/// strongly correlated, so a standard error would be meaningless: the spread of the octaves' own exponents is given.
/// Nothing where an octave holds fewer than three positive values, where the two exponents differ by more than 1/2 (no
/// power law), or where `y` ends at or below `floor` (round-off has no useful growth law).
std::optional<GrowthLaw> fit_growth(const std::vector<double>& t, const std::vector<double>& y, double floor);

}  // namespace kreisel
