// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table_fit.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace kreisel {

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
    if (x.size() != y.size()) { throw std::invalid_argument("fit_line: as many ordinates as abscissae are needed"); }
    if (std::adjacent_find(x.begin(), x.end(), std::not_equal_to<>()) == x.end()) {
        throw std::invalid_argument("fit_line: two different abscissae are needed");
    }
    // The default handler would end the program; here an error is the caller's to see.
    [[maybe_unused]] static gsl_error_handler_t* const aborting = gsl_set_error_handler_off();
    Line line;
    double var_intercept = 0, covariance = 0, var_slope = 0, residual = 0;
    const int status = gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &line.intercept, &line.slope, &var_intercept,
                                      &covariance, &var_slope, &residual);
    if (status != GSL_SUCCESS) { throw std::runtime_error(std::string("fit_line: ") + gsl_strerror(status)); }
    if (x.size() > 2) { line.slope_error = std::sqrt(var_slope); }  // residual / (n - 2) is no variance for two points
    return line;
}

std::optional<GrowthLaw> fit_growth(const std::vector<double>& t, const std::vector<double>& y, double floor) {
    if (t.empty() || y.size() != t.size()) { return std::nullopt; }
    std::vector<double> log_t, log_y;
    double largest = 0;
    const double half = (t.front() + t.back()) / 2;
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (t[i] < half || !(t[i] > 0) || !(y[i] > 0) || !std::isfinite(y[i])) { continue; }
        log_t.push_back(std::log(t[i]));
        log_y.push_back(std::log(y[i]));
        largest = std::max(largest, y[i]);
    }
    if (log_t.size() < 4 || largest <= floor) { return std::nullopt; }
    const Line line = fit_line(log_t, log_y);
    return GrowthLaw{line.slope, line.slope_error, std::exp(line.intercept), std::exp(log_t.front()),
                     std::exp(log_t.back())};
}

}  // namespace kreisel
