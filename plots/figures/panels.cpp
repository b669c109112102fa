// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/panels.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/layout.hpp"
#include "plots/figures/marks/offset_marks.hpp"
#include "plots/figures/settings.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

std::string points_text(const std::vector<Point>& points, const Panel& panel) {
    std::string text;
    for (const Point& point : points) {
        text += is_drawable(point, panel) ? fmt::format("{} {}\n", point.x, point.y) : "\n";
    }
    return text.empty() || text.find_first_not_of('\n') == std::string::npos ? "NaN NaN\n" : text;  // keeps the legend
}

std::string guides_text(const Panel& panel) {
    std::string text;
    for (const auto& guide : panel.guides) { text += points_text(guide, panel) + "\n"; }
    return text;
}

void write_layout(Settings& settings, const PageLayout& layout) {
    settings.number("width_cm", layout.width);
    settings.number("height_cm", layout.height);
    settings.numbers("panel_left", layout.left);
    settings.numbers("panel_right", layout.right);
    settings.numbers("panel_bottom", layout.bottom);
    settings.numbers("panel_top", layout.top);
    settings.numbers("legend_top", layout.legend_top);
}

void write_axes(Settings& settings, const PanelFigure& figure, double width) {
    const std::vector<Panel>& panels = figure.panels;
    std::vector<double> x_low, x_high, y_low, y_high;
    for (const Panel& panel : panels) {
        const auto [x, y] = axis_ranges(panel);
        x_low.push_back(x.low);
        x_high.push_back(x.high);
        y_low.push_back(y.low);
        y_high.push_back(y.high);
    }
    settings.numbers("x_low", x_low);
    settings.numbers("x_high", x_high);
    settings.numbers("y_low", y_low);
    settings.numbers("y_high", y_high);
    const auto flag = [](bool value) { return value ? "1" : "0"; };
    settings.array("log_x", panels, [&](const Panel& panel) { return flag(panel.log_x); });
    settings.array("log_y", panels, [&](const Panel& panel) { return flag(panel.log_y); });
    settings.number("legend_row", legend_row_height(figure));
    settings.array("legend_width", panels, [&](const Panel& panel) {  // of a column of it
        return fmt::format("{}", legend_of(panel, figure, width).column_width);
    });
    settings.array("legend_rows", panels,
                   [&](const Panel& panel) { return fmt::format("{}", legend_of(panel, figure, width).rows); });
    settings.array("panel_title", panels, [](const Panel& panel) { return gnuplot_quoted(panel.title); });
    settings.array("x_label", panels, [](const Panel& panel) { return gnuplot_quoted(panel.x_label); });
    settings.array("y_label", panels, [](const Panel& panel) { return gnuplot_quoted(panel.y_label); });
}

// Curves and marks of all panels in one sequence; panel p owns first[p] to last[p].
void write_contents(Settings& settings, const std::filesystem::path& plotdata, const PanelFigure& figure) {
    std::vector<std::string> files, labels, mark_texts;
    std::vector<double> styles, first, last, mark_x, mark_y, first_mark, last_mark, guides;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        const Panel& panel = figure.panels[p];
        first.push_back(static_cast<double>(files.size() + 1));
        for (const Curve& curve : panel.curves) {
            files.push_back(fmt::format("{}.{}.dat", figure.name, files.size() + 1));
            labels.push_back(curve.label);
            styles.push_back(curve.style);
            write_atomically(plotdata / files.back(), points_text(curve.points, panel));
        }
        last.push_back(static_cast<double>(files.size()));
        guides.push_back(panel.guides.empty() ? 0 : 1);
        write_atomically(plotdata / fmt::format("{}.guides{}.dat", figure.name, p + 1), guides_text(panel));
        first_mark.push_back(static_cast<double>(mark_texts.size() + 1));
        for (const Mark& mark : panel.marks) {
            mark_texts.push_back(mark.text);
            mark_x.push_back(mark.at.x);
            mark_y.push_back(mark.at.y);
        }
        last_mark.push_back(static_cast<double>(mark_texts.size()));
    }
    settings.strings("curve_file", files);
    settings.strings("curve_label", labels);
    settings.numbers("curve_style", styles);
    settings.numbers("first_curve", first);
    settings.numbers("last_curve", last);
    settings.numbers("has_guides", guides);
    settings.strings("mark_text", mark_texts);
    settings.numbers("mark_x", mark_x);
    settings.numbers("mark_y", mark_y);
    settings.numbers("first_mark", first_mark);
    settings.numbers("last_mark", last_mark);
}

// The points of all panels that bear marks, curve after curve; panel p owns first[p] to last[p].
void write_offset_marks(Settings& settings, const std::filesystem::path& plotdata, const PanelFigure& figure) {
    std::vector<std::string> files;
    std::vector<double> styles, first, last, bearing;
    for (const Panel& panel : figure.panels) {
        first.push_back(static_cast<double>(files.size() + 1));
        const auto marked = offset_marks(panel);
        for (std::size_t i = 0; i < panel.curves.size(); ++i) {
            bearing.push_back(marked[i].empty() ? 0 : 1);
            if (marked[i].empty()) { continue; }
            std::vector<Point> points;
            for (const std::size_t k : marked[i]) { points.push_back(panel.curves[i].points[k]); }
            files.push_back(fmt::format("{}.{}.marks.dat", figure.name, bearing.size()));
            styles.push_back(panel.curves[i].style);
            write_atomically(plotdata / files.back(), points_text(points, panel));
        }
        last.push_back(static_cast<double>(files.size()));
    }
    settings.strings("marks_file", files);
    settings.numbers("marks_style", styles);
    settings.numbers("first_marks", first);
    settings.numbers("last_marks", last);
    settings.numbers("bears_marks", bearing);
}

}  // namespace

void write_panels(const std::filesystem::path& plotdata, const PanelFigure& figure) {
    make_folder(plotdata);
    Settings settings;
    settings.string("figure_name", figure.name);
    settings.string("figure_title", figure.title);
    settings.string("figure_note", figure.note);
    settings.number("font_size", figure.font_size);
    settings.number("panels", static_cast<double>(figure.panels.size()));
    const PageLayout layout = layout_of(figure);
    write_layout(settings, layout);
    write_axes(settings, figure, layout.panel_width);
    write_contents(settings, plotdata, figure);
    write_offset_marks(settings, plotdata, figure);
    write_atomically(plotdata / (figure.name + ".gp"), settings.text());
}

}  // namespace kreisel
