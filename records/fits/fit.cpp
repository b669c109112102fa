// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/fits/fit.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace kreisel {

namespace {

// Local exponents of two octaves that differ by more than this do not indicate a power law.
constexpr double largest_disagreement = 0.5;

}  // namespace

FittedLine fit_line(const std::vector<double>& x, const std::vector<double>& y) {
    if (x.size() != y.size()) { throw std::invalid_argument("fit_line: as many ordinates as abscissae are needed"); }
    if (std::adjacent_find(x.begin(), x.end(), std::not_equal_to<>()) == x.end()) {
        throw std::invalid_argument("fit_line: two different abscissae are needed");
    }
    // The default handler would end the program; here errors are returned to the caller.
    [[maybe_unused]] static gsl_error_handler_t* const aborting = gsl_set_error_handler_off();
    FittedLine line;
    double var_intercept = 0, covariance = 0, var_slope = 0, residual = 0;
    const int status = gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &line.intercept, &line.slope, &var_intercept,
                                      &covariance, &var_slope, &residual);
    if (status != GSL_SUCCESS) { throw std::runtime_error(std::string("fit_line: ") + gsl_strerror(status)); }
    if (x.size() > 2) {
        line.slope_error = std::sqrt(var_slope);
    }  // residual / (n - 2) is not a variance for two points
    return line;
}

namespace {

struct LogCurve {
    std::vector<double> t, y;
};

// Positive values at times in [from, to].
LogCurve logarithms(const std::vector<double>& t, const std::vector<double>& y, double from, double to) {
    LogCurve curve;
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (!(t[i] > 0) || t[i] < from || t[i] > to || !(y[i] > 0) || !std::isfinite(y[i])) { continue; }
        curve.t.push_back(std::log(t[i]));
        curve.y.push_back(std::log(y[i]));
    }
    return curve;
}

}  // namespace

std::optional<GrowthLaw> fit_growth(const std::vector<double>& t, const std::vector<double>& y, double floor) {
    if (t.empty() || y.size() != t.size() || !(t.back() > 0)) { return std::nullopt; }
    const double end = t.back();
    const LogCurve early = logarithms(t, y, end / 4, end / 2), late = logarithms(t, y, end / 2, end);
    if (early.t.size() < 3 || late.t.size() < 3 || std::exp(late.y.back()) <= floor) { return std::nullopt; }
    const LogCurve all = logarithms(t, y, end / 4, end);
    const FittedLine line = fit_line(all.t, all.y);
    const double first = fit_line(early.t, early.y).slope, second = fit_line(late.t, late.y).slope;
    if (std::abs(first - second) > largest_disagreement) { return std::nullopt; }
    const double spread = std::max(std::abs(first - line.slope), std::abs(second - line.slope));
    return GrowthLaw{.exponent = line.slope,
                     .coefficient = std::exp(line.intercept),
                     .spread = spread,
                     .from = std::exp(all.t.front()),
                     .to = std::exp(all.t.back())};
}

}  // namespace kreisel
