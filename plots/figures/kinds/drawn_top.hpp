// SPDX-License-Identifier: BSD-3-Clause
//
// The picture of a top.
#pragma once

#include <array>
#include <vector>

namespace kreisel {

using Point3 = std::array<double, 3>;

/// Polylines of a stylised top at one instant: the rod from its tip at x - R lever through the mass centre, a rim of
/// `radius` about the mass centre across the rod, a mark on the rim that shows the spin, and lines from tip to rim.
/// x: mass centre in space axes, m. R: body to space, row by row. lever: tip to mass centre in body axes, m, not zero.
std::vector<std::vector<Point3>> drawn_top(const Point3& x, const std::array<double, 9>& R, const Point3& lever,
                                           double radius);

}  // namespace kreisel
