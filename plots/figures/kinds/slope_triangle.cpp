// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/slope_triangle.hpp"

#include <fmt/format.h>

#include <cmath>

namespace kreisel {

SlopeTriangle slope_triangle(const std::vector<Point>& window, int order) {
    const std::size_t middle = (window.size() - 1) / 2;
    const Point coarse = window[middle], fine = window[middle + 1];
    const double drop = std::pow(10.0, -0.35);
    const double base = fine.y * drop, tip = base * std::pow(coarse.x / fine.x, order);
    SlopeTriangle triangle{{{fine.x, base}, {coarse.x, base}, {coarse.x, tip}, {fine.x, base}}, {}};
    triangle.order = {{coarse.x * 1.22, std::sqrt(base * tip)}, fmt::format("{}", order)};
    return triangle;
}

}  // namespace kreisel
