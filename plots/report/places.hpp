// SPDX-License-Identifier: BSD-3-Clause
//
// Heat maps and figures in space as data of the page.
#pragma once

#include <string>

#include "plots/figures/kinds/heat_map.hpp"
#include "plots/figures/kinds/space_kind.hpp"

namespace kreisel {

/// {"width", "axes_height" (cm, those that are given), "font_size" (points), "x_label", "y_label", "x_values",
/// "y_values", "log", "maps": [{"label", "places": [[x, y, value], ...]}]}; labels are enhanced text of gnuplot, x and y
/// count the values of the axes from 0.
std::string heat_json(const HeatMapData& data);

/// {"width" (cm, if it is given), "font_size" (points), "low", "high", "view", "t", "path", "lines": [[t, points],
/// ...]}: six digits (m, s) of at most 500 instants of the path, and of as many lines, evenly left out, as have 8000
/// points.
std::string space_json(const SpaceData& data);

}  // namespace kreisel
