// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of curves: convergence, drift, invariants, components.
#pragma once

#include "experiments/figure.hpp"
#include "experiments/figure_panels.hpp"
#include "experiments/table_names.hpp"

namespace kreisel {

/// A figure that cannot be drawn from these results, and why.
struct FigureError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The rows that `spec.select` leaves, but for skipped ones; with `failed` also those that did not run to their end.
/// Throws FigureError where none is left.
std::vector<ResultRow> selected_rows(const FigureSpec& spec, const Results& results, bool failed = false);

/// The one cell with samples that a figure of a trajectory draws. Throws FigureError unless there is exactly one.
ResultRow selected_trajectory(const FigureSpec& spec, const Results& results);

/// Errors against step size, with the observed order of each curve in the legend and slope triangles.
PanelFigure convergence_figure(const FigureSpec& spec, const Results& results);
/// Running maxima of defects against time with fitted growth laws.
PanelFigure drift_figure(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder);
/// Running maxima of |I - I0|, or of |I - I0|/|I0|, against time.
PanelFigure invariants_figure(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder);
/// The components of x, v, omega or the multipliers against time.
PanelFigure components_figure(const FigureSpec& spec, const Results& results, const std::filesystem::path& folder);

/// The samples of the selected cell, up to `spec.until`.
TrajectoryTable selected_samples(const FigureSpec& spec, const ResultRow& row, const std::filesystem::path& folder);

/// The body that the figure draws: as asked for, or the first. Throws FigureError where there is no such body.
std::string body_of(const FigureSpec& spec, const TrajectoryTable& trajectory);

/// Axis label of a metric in enhanced text, with its unit.
std::string metric_label(const std::string& metric);

/// The triangle of slope `order` below the lowest curve of that slope, from the data of the curves' windows.
struct SlopeTriangle {
    std::vector<Point> outline;
    Mark order;
};
SlopeTriangle slope_triangle(const std::vector<Point>& window, int order);

}  // namespace kreisel
