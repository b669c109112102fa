// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/layout.hpp"

#include <algorithm>
#include <cmath>

#include "plots/figures/enhanced_text.hpp"

namespace kreisel {

namespace {

// Centimetres on the page, for letters of the standard size.
constexpr double column_width = 8.5, page_width = 17.0;
constexpr double left_margin = 1.6, right_margin = 0.4, bottom_margin = 0.95, bare_bottom = 0.4;
constexpr double legend_gap = 0.15, title_height = 0.5;
constexpr double character = 0.14, legend_sample = 1.15, legend_row = 0.335, raised_row = 0.4;

// By how much letters, and the space around them, are larger than the standard.
double scale_of(const PanelFigure& figure) { return figure.font_size / standard_font_size; }

void include(AxisRange& range, double value) {
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
}

// A margin around the data; an axis without extent gets one.
AxisRange padded(AxisRange range, bool logarithmic) {
    if (!(range.low <= range.high)) { return logarithmic ? AxisRange{0.1, 1} : AxisRange{0, 1}; }
    if (logarithmic) {
        const double margin = std::max(std::pow(range.high / range.low, 0.06), 1.15);
        return {range.low / margin, range.high * margin};
    }
    const double span = range.high - range.low;
    const double margin =
        span > 1e-9 * std::abs(range.high) ? 0.05 * span : std::max(std::abs(range.high) * 0.05, 1e-12);
    return {range.low - margin, range.high + margin};
}

// Centimetres that a legend entry takes, with its sample.
double entry_width(const Curve& curve, const PanelFigure& figure) {
    return scale_of(figure) * (legend_sample + character * static_cast<double>(enhanced_width(curve.label)));
}

// The longest of a panel.
double legend_entry(const Panel& panel, const PanelFigure& figure) {
    double widest = scale_of(figure) * legend_sample;
    for (const Curve& curve : panel.curves) { widest = std::max(widest, entry_width(curve, figure)); }
    return widest;
}

// A column of the page for one or two panels beside each other; more share the page. A legend is never cut: a panel is
// at least as wide as its longest entry and its title, unless the width of the page is given.
double panel_width_of(const PanelFigure& figure) {
    const auto columns = std::min(figure.columns, static_cast<long>(figure.panels.size()));
    if (figure.width) { return *figure.width / static_cast<double>(columns); }
    double width = columns <= 2 ? column_width : page_width / static_cast<double>(columns);
    for (const Panel& panel : figure.panels) {
        const double title = character * static_cast<double>(enhanced_width(panel.title)) + left_margin;
        width = std::max(
            width, std::max(legend_entry(panel, figure), scale_of(figure) * title) + scale_of(figure) * right_margin);
    }
    return width;
}

// Whether a label has something raised, which would touch the row above.
bool is_raised(const Curve& curve) {
    const std::size_t at = curve.label.find("^{");
    return at != std::string::npos && (at == 0 || curve.label[at - 1] != '\\');
}

double top_margin_of(const PanelFigure& figure) {
    const bool titles =
        std::any_of(figure.panels.begin(), figure.panels.end(), [](const Panel& p) { return !p.title.empty(); });
    return (titles ? 0.6 : 0.25) * scale_of(figure);
}

}  // namespace

bool is_drawable(const Point& point, const Panel& panel) {
    return std::isfinite(point.x) && std::isfinite(point.y) && (!panel.log_x || point.x > 0) &&
           (!panel.log_y || point.y > 0);
}

std::pair<AxisRange, AxisRange> axis_ranges(const Panel& panel) {
    AxisRange x, y;
    const auto add = [&](const std::vector<Point>& points) {
        for (const Point& point : points) {
            if (!is_drawable(point, panel)) { continue; }
            include(x, point.x);
            include(y, point.y);
        }
    };
    for (const Curve& curve : panel.curves) { add(curve.points); }
    for (const auto& guide : panel.guides) { add(guide); }
    for (const Mark& mark : panel.marks) { add({mark.at}); }
    AxisRange wide_x = padded(x, panel.log_x), wide_y = padded(y, panel.log_y);
    if (!panel.log_x && x.low >= 0 && x.low < 0.05 * x.high) { wide_x = {0, x.high}; }  // time starts at the axis
    if (panel.from_zero) { wide_y = {0, padded({0, y.high}, false).high}; }
    if (panel.x_range) { wide_x = {panel.x_range->front(), panel.x_range->back()}; }
    if (panel.y_range) { wide_y = {panel.y_range->front(), panel.y_range->back()}; }
    return {wide_x, wide_y};
}

double legend_row_height(const PanelFigure& figure) {
    const bool raised = std::any_of(figure.panels.begin(), figure.panels.end(), [](const Panel& panel) {
        return std::any_of(panel.curves.begin(), panel.curves.end(), is_raised);
    });
    return (raised ? raised_row : legend_row) * scale_of(figure);
}

LegendLayout legend_of(const Panel& panel, const PanelFigure& figure, double panel_width) {
    const std::size_t count = panel.curves.size();
    const double space = panel_width - scale_of(figure) * right_margin;
    if (count == 1 && panel.curves.front().label.empty()) { return {1, 0, space}; }
    const auto fitting = static_cast<std::size_t>(space / legend_entry(panel, figure));
    const std::size_t columns = std::clamp<std::size_t>(fitting, 1, std::max<std::size_t>(count, 1));
    return {columns, (count + columns - 1) / columns, space / static_cast<double>(columns)};
}

TooWide too_wide_label(const PanelFigure& figure) {
    const double space = panel_width_of(figure) - scale_of(figure) * right_margin;
    if (!figure.width) { return {}; }
    for (const Panel& panel : figure.panels) {
        for (const Curve& curve : panel.curves) {
            const double width = entry_width(curve, figure);
            if (width > space) { return {&curve, width, space}; }
        }
    }
    return {};
}

PageLayout layout_of(const PanelFigure& figure) {
    const std::size_t n = figure.panels.size();
    const std::size_t columns = std::min<std::size_t>(n, static_cast<std::size_t>(figure.columns));
    PageLayout layout;
    const double panel_width = panel_width_of(figure);
    layout.panel_width = panel_width;
    const double axes_height = figure.axes_height, scale = scale_of(figure);
    layout.width = panel_width * static_cast<double>(columns);
    layout.height = scale * ((figure.title.empty() ? 0 : title_height) + (figure.note.empty() ? 0 : title_height));
    std::vector<double> row_top;
    for (std::size_t first = 0; first < n; first += columns) {
        std::size_t legend_rows = 0;
        double bottom = bare_bottom;
        for (std::size_t i = first; i < std::min(n, first + columns); ++i) {
            legend_rows = std::max(legend_rows, legend_of(figure.panels[i], figure, panel_width).rows);
            bottom = figure.panels[i].x_label.empty() ? bottom : bottom_margin;
        }
        row_top.push_back(layout.height);
        const double top_margin = top_margin_of(figure);
        layout.height += top_margin + axes_height + scale * (bottom + legend_gap) +
                         legend_row_height(figure) * static_cast<double>(legend_rows);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double x = panel_width * static_cast<double>(i % columns);
        const double y = row_top[i / columns] + top_margin_of(figure);
        layout.left.push_back((x + scale * left_margin) / layout.width);
        layout.right.push_back((x + panel_width - scale * right_margin) / layout.width);
        layout.top.push_back(1 - y / layout.height);
        layout.bottom.push_back(1 - (y + axes_height) / layout.height);
        layout.legend_top.push_back(1 - (y + axes_height + scale * bottom_margin) / layout.height);
    }
    return layout;
}

}  // namespace kreisel
