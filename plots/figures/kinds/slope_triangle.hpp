// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles that show an order.
#pragma once

#include <vector>

#include "plots/figures/panels.hpp"

namespace kreisel {

/// The triangle of slope `order` below the lowest curve of that slope, from the data of the curve's window.
struct SlopeTriangle {
    std::vector<Point> outline;
    Mark order;
};
SlopeTriangle slope_triangle(const std::vector<Point>& window, int order);

}  // namespace kreisel
