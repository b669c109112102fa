// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/table_fit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace kreisel {

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0, yy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / n;
        mean_y += y.at(i) / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = x[i] - mean_x, dy = y[i] - mean_y;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
    }
    if (!(xx > 0)) { throw std::invalid_argument("fit_line: two different abscissae are needed"); }
    Line line{xy / xx, 0, 0};
    line.intercept = mean_y - line.slope * mean_x;
    if (x.size() > 2) { line.slope_error = std::sqrt(std::max(yy - line.slope * xy, 0.0) / (n - 2) / xx); }
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
