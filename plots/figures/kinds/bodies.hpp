// SPDX-License-Identifier: BSD-3-Clause
//
// Figures in space: the path of a mass centre, and the motion as a sequence of drawn tops.
#pragma once

#include <filesystem>

#include "plots/figures/kinds/curves.hpp"

namespace kreisel {

using Point3 = std::array<double, 3>;

/// Polylines of a stylised top at one instant: the rod from its tip at x - R lever through the mass centre, a rim of
/// `radius` about the mass centre across the rod, a mark on the rim that shows the spin, and lines from tip to rim.
/// x: mass centre in space axes, m. R: body to space, row by row. lever: tip to mass centre in body axes, m, not zero.
std::vector<std::vector<Point3>> drawn_top(const Point3& x, const std::array<double, 9>& R, const Point3& lever,
                                           double radius);

/// Writes settings and data of a path3d or motion figure into plotdata/. Throws FigureError, FileError.
void write_bodies(const std::filesystem::path& plotdata, const FigureSpec& spec, const Results& results,
                  const std::filesystem::path& folder);

}  // namespace kreisel
