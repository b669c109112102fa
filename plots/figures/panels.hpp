// SPDX-License-Identifier: BSD-3-Clause
//
// A figure as plain data: panels with curves, axes and labels, and where they lie on the page. gnuplot only draws it.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace kreisel {

struct Point {
    double x = 0, y = 0;

    bool operator==(const Point&) const = default;
};

/// Labels here are enhanced text of gnuplot: text from outside must pass through enhanced_escape first.
struct Curve {
    std::string label;
    std::vector<Point> points;
    int style = 1;                   ///< line, point and dash type; equal numbers have equal styles in all panels
    std::vector<Point> fitted = {};  ///< those that the order in the label was fitted to
    std::string name = {};           ///< plain text that keys of a figure call it by; empty: they do not
};

struct Mark {
    Point at;
    std::string text;
};

struct Panel {
    std::string title, x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Curve> curves;
    std::vector<std::vector<Point>> guides;  ///< thin grey lines without a legend: fitted laws, slope triangles
    std::vector<Mark> marks;                 ///< small grey texts centred at a point
    bool from_zero = false;                  ///< a linear y axis that starts at zero, whatever the data
    std::optional<std::array<double, 2>> x_range = {}, y_range = {};  ///< nothing: all that is drawn
};

/// On the page.
inline constexpr double standard_font_size = 7.5;  ///< points
inline constexpr double mm_per_cm = 10;

struct PanelFigure {
    std::string name, title;
    std::vector<Panel> panels;
    long columns = 2;
    double axes_height = 5;                 ///< cm
    std::optional<double> width = {};       ///< of the page, cm; nothing: as the panels and their legends require
    double font_size = standard_font_size;  ///< points
    std::string note = {};                  ///< small, below the title
};

/// Writes plotdata/<name>.gp (titles, ranges, layout) and one data file per curve and panel. Throws FileError, and
/// std::invalid_argument where a label holds a control character.
void write_panels(const std::filesystem::path& plotdata, const PanelFigure& figure);

}  // namespace kreisel
