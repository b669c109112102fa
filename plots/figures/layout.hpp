// SPDX-License-Identifier: BSD-3-Clause
//
// Where the panels of a figure and their legends lie on the page, and the ranges of their axes.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "plots/figures/panels.hpp"

namespace kreisel {

/// Positions in fractions of the page: rows of panels, each row as high as its longest legend requires.
struct PageLayout {
    double width = 0, height = 0;  ///< cm
    double panel_width = 0;        ///< cm, margins included
    std::vector<double> left, right, bottom, top, legend_top;
};
PageLayout layout_of(const PanelFigure& figure);

/// The legend of a panel, below it.
struct LegendLayout {
    std::size_t columns = 1, rows = 0;
    double column_width = 0;  ///< cm
};
LegendLayout legend_of(const Panel& panel, const PanelFigure& figure, double panel_width);
/// Height of a row of it, cm.
double legend_row_height(const PanelFigure& figure);

/// The label that does not fit below its panel, in a figure whose width is given; null where all do.
struct TooWide {
    const Curve* curve = nullptr;
    double width = 0, space = 0;  ///< cm
};
TooWide too_wide_label(const PanelFigure& figure);

struct AxisRange {
    double low = std::numeric_limits<double>::infinity(), high = -low;
};
/// Of x and y: all that is drawn, with a margin.
std::pair<AxisRange, AxisRange> axis_ranges(const Panel& panel);

/// Whether a point is finite, and positive where an axis is logarithmic.
bool is_drawable(const Point& point, const Panel& panel);

}  // namespace kreisel
