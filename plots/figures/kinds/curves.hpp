// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of curves: convergence, drift, invariants, components.
#pragma once

#include "plots/figures/panels.hpp"
#include "plots/figures/select.hpp"
#include "plots/figures/spec.hpp"
#include "plots/tables/names.hpp"

namespace kreisel {

/// Errors against step size, with the observed order of each curve in the legend and slope triangles.
PanelFigure convergence_figure(const FigureSpec& spec, const Results& results);
/// Running maxima of defects against time with fitted growth laws.
PanelFigure drift_figure(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder);
/// Running maxima of |I - I0|, or of |I - I0|/|I0|, against time.
PanelFigure invariants_figure(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder);
/// Time and memory against the number of bodies, with the exponent of each curve in the legend.
PanelFigure scaling_figure(const FigureSpec& spec, const Results& results);
/// The components of x, v, omega or the multipliers against time.
PanelFigure components_figure(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder);

/// Axis label of a metric in enhanced text, with its unit.
std::string metric_label(const std::string& metric, const Units& units);

/// The triangle of slope `order` below the lowest curve of that slope, from the data of the curves' windows.
struct SlopeTriangle {
    std::vector<Point> outline;
    Mark order;
};
SlopeTriangle slope_triangle(const std::vector<Point>& window, int order);

}  // namespace kreisel
