// SPDX-License-Identifier: BSD-3-Clause
//
// Curves that a figure shows beside those of its cells: published ones, those of other programs.
#pragma once

#include <string>
#include <vector>

#include "plots/figures/panels.hpp"
#include "plots/figures/values.hpp"

namespace kreisel {

inline constexpr std::size_t most_overlay_points = 10'000;

struct Overlay {
    std::string label;
    std::vector<Point> points;  ///< NaN interrupts the curve
    long panel = 0;             ///< from 1; 0: all

    bool operator==(const Overlay&) const = default;
};

/// For the key of a figure.
nlohmann::ordered_json json_of(const std::vector<Overlay>& overlays);

/// Adds them to the panels, in styles of their own. Throws FigureError where there is no such panel.
void add_overlays(const std::vector<Overlay>& overlays, PanelFigure& figure);

namespace figure_value {

/// An object, or a list of them: "label", and "points", [x, y] each, or "file", "x", "y" (overlay_files.hpp).
Type<std::vector<Overlay>> overlays();

}  // namespace figure_value

}  // namespace kreisel
