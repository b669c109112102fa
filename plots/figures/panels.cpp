// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "records/json/node.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

// Centimetres on the page.
constexpr double column_width = 8.5, page_width = 17.0;
constexpr double left_margin = 1.6, right_margin = 0.4, bottom_margin = 0.95, bare_bottom = 0.4;
constexpr double legend_row = 0.335, legend_gap = 0.15, title_height = 0.5;
constexpr double character = 0.14, legend_sample = 1.15;

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

// A margin around the data; an axis without extent gets one.
Range padded(Range range, bool logarithmic) {
    if (!(range.low <= range.high)) { return logarithmic ? Range{0.1, 1} : Range{0, 1}; }
    if (logarithmic) {
        const double margin = std::max(std::pow(range.high / range.low, 0.06), 1.15);
        return {range.low / margin, range.high * margin};
    }
    const double span = range.high - range.low;
    const double margin =
        span > 1e-9 * std::abs(range.high) ? 0.05 * span : std::max(std::abs(range.high) * 0.05, 1e-12);
    return {range.low - margin, range.high + margin};
}

bool drawable(const Point& point, const Panel& panel) {
    return std::isfinite(point.x) && std::isfinite(point.y) && (!panel.log_x || point.x > 0) &&
           (!panel.log_y || point.y > 0);
}

std::pair<Range, Range> ranges(const Panel& panel) {
    Range x, y;
    const auto add = [&](const std::vector<Point>& points) {
        for (const Point& point : points) {
            if (!drawable(point, panel)) { continue; }
            x.add(point.x);
            y.add(point.y);
        }
    };
    for (const Curve& curve : panel.curves) { add(curve.points); }
    for (const auto& guide : panel.guides) { add(guide); }
    for (const Mark& mark : panel.marks) { add({mark.at}); }
    Range wide_x = padded(x, panel.log_x);
    if (!panel.log_x && x.low >= 0 && x.low < 0.05 * x.high) { wide_x = {0, x.high}; }  // time starts at the axis
    if (panel.from_zero) { return {wide_x, {0, padded({0, y.high}, false).high}}; }
    return {wide_x, padded(y, panel.log_y)};
}

// Centimetres that the longest legend entry of a panel takes, with its sample.
double legend_entry(const Panel& panel) {
    std::size_t widest = 0;
    for (const Curve& curve : panel.curves) { widest = std::max(widest, enhanced_width(curve.label)); }
    return legend_sample + character * static_cast<double>(widest);
}

struct Legend {
    std::size_t columns = 1, rows = 0;
};

Legend legend_of(const Panel& panel, double panel_width) {
    const std::size_t count = panel.curves.size();
    if (count == 1 && panel.curves.front().label.empty()) { return {1, 0}; }
    const auto fitting = static_cast<std::size_t>((panel_width - right_margin) / legend_entry(panel));
    const std::size_t columns = std::clamp<std::size_t>(fitting, 1, std::max<std::size_t>(count, 1));
    return {columns, (count + columns - 1) / columns};
}

// Text file of assignments, read by plots/gnuplot/panels.gp.
class Settings {
  public:
    void number(const std::string& name, double value) { text_ += fmt::format("{} = {}\n", name, value); }
    void string(const std::string& name, const std::string& value) {
        text_ += fmt::format("{} = {}\n", name, gnuplot_quoted(value));
    }
    template <class Item, class Write>
    void array(const std::string& name, const std::vector<Item>& items, const Write& write) {
        std::string list;
        for (const Item& item : items) { list += (list.empty() ? "" : ",") + std::string(write(item)); }
        text_ += fmt::format("array {}[{}] = [{}]\n", name, std::max<std::size_t>(items.size(), 1),
                             items.empty() ? "0" : list);
    }
    void numbers(const std::string& name, const std::vector<double>& values) {
        array(name, values, [](double value) { return fmt::format("{}", value); });
    }
    void strings(const std::string& name, const std::vector<std::string>& values) {
        array(name, values, [](const std::string& value) { return gnuplot_quoted(value); });
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_ = "# Written by kreisel plot.\n";
};

// A column of the page for one or two panels beside each other; more share the page. A legend is never cut: a panel is
// at least as wide as its longest entry.
double panel_width_of(const PanelFigure& figure) {
    const auto columns = std::min(figure.columns, static_cast<long>(figure.panels.size()));
    double width = columns <= 2 ? column_width : page_width / static_cast<double>(columns);
    for (const Panel& panel : figure.panels) { width = std::max(width, legend_entry(panel) + right_margin); }
    return width;
}

double top_margin_of(const PanelFigure& figure) {
    const bool titles =
        std::any_of(figure.panels.begin(), figure.panels.end(), [](const Panel& p) { return !p.title.empty(); });
    return titles ? 0.6 : 0.25;
}

// Where the panels lie: rows of panels, each row as high as its longest legend requires.
struct Layout {
    double width = 0, height = 0;                              // cm
    std::vector<double> left, right, bottom, top, legend_top;  // fractions of the page
};

Layout layout_of(const PanelFigure& figure) {
    const std::size_t n = figure.panels.size();
    const std::size_t columns = std::min<std::size_t>(n, static_cast<std::size_t>(figure.columns));
    Layout layout;
    const double panel_width = panel_width_of(figure);
    const double axes_height = figure.axes_height;
    layout.width = panel_width * static_cast<double>(columns);
    layout.height = figure.title.empty() ? 0 : title_height;
    std::vector<double> row_top;
    for (std::size_t first = 0; first < n; first += columns) {
        std::size_t legend_rows = 0;
        double bottom = bare_bottom;
        for (std::size_t i = first; i < std::min(n, first + columns); ++i) {
            legend_rows = std::max(legend_rows, legend_of(figure.panels[i], panel_width).rows);
            bottom = figure.panels[i].x_label.empty() ? bottom : bottom_margin;
        }
        row_top.push_back(layout.height);
        const double top_margin = top_margin_of(figure);
        layout.height += top_margin + axes_height + bottom + legend_gap + legend_row * static_cast<double>(legend_rows);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double x = panel_width * static_cast<double>(i % columns);
        const double y = row_top[i / columns] + top_margin_of(figure);
        layout.left.push_back((x + left_margin) / layout.width);
        layout.right.push_back((x + panel_width - right_margin) / layout.width);
        layout.top.push_back(1 - y / layout.height);
        layout.bottom.push_back(1 - (y + axes_height) / layout.height);
        layout.legend_top.push_back(1 - (y + axes_height + bottom_margin) / layout.height);
    }
    return layout;
}

std::string points_text(const std::vector<Point>& points, const Panel& panel) {
    std::string text;
    for (const Point& point : points) {
        text += drawable(point, panel) ? fmt::format("{} {}\n", point.x, point.y) : "\n";
    }
    return text.empty() || text.find_first_not_of('\n') == std::string::npos ? "NaN NaN\n" : text;  // keeps the legend
}

std::string guides_text(const Panel& panel) {
    std::string text;
    for (const auto& guide : panel.guides) { text += points_text(guide, panel) + "\n"; }
    return text;
}

void write_layout(Settings& settings, const Layout& layout) {
    settings.number("width_cm", layout.width);
    settings.number("height_cm", layout.height);
    settings.numbers("panel_left", layout.left);
    settings.numbers("panel_right", layout.right);
    settings.numbers("panel_bottom", layout.bottom);
    settings.numbers("panel_top", layout.top);
    settings.numbers("legend_top", layout.legend_top);
}

void write_axes(Settings& settings, const PanelFigure& figure) {
    const std::vector<Panel>& panels = figure.panels;
    const double width = panel_width_of(figure);
    std::vector<double> x_low, x_high, y_low, y_high;
    for (const Panel& panel : panels) {
        const auto [x, y] = ranges(panel);
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
    settings.number("legend_row", legend_row);
    settings.array("legend_width", panels, [&](const Panel& panel) {  // of a column of it
        return fmt::format("{}", (width - right_margin) / static_cast<double>(legend_of(panel, width).columns));
    });
    settings.array("legend_rows", panels,
                   [&](const Panel& panel) { return fmt::format("{}", legend_of(panel, width).rows); });
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

}  // namespace

std::string gnuplot_quoted(const std::string& text) {
    if (has_control_character(text)) { throw std::invalid_argument("a label of a figure holds a control character"); }
    // gnuplot 5.4 does not read its own escape '' at the start of a string, and goes on with the rest as a command.
    std::string quoted = "'";
    for (const char c : text) { quoted += c == '\'' ? std::string("\u2019") : std::string(1, c); }
    return quoted + "'";
}

std::string enhanced_escape(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (std::string_view("{}^_@&~\\").find(c) != std::string_view::npos) { escaped += '\\'; }
        escaped += c;
    }
    return escaped;
}

std::size_t enhanced_width(const std::string& text) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (std::string_view("{}^_").find(text[i]) != std::string_view::npos) { continue; }
        if (text[i] == '\\') { ++i; }
        if (i < text.size() && (text[i] & 0xC0) != 0x80) { ++count; }
    }
    return count;
}

void write_panels(const std::filesystem::path& plotdata, const PanelFigure& figure) {
    make_folder(plotdata);
    Settings settings;
    settings.string("figure_name", figure.name);
    settings.string("figure_title", figure.title);
    settings.number("panels", static_cast<double>(figure.panels.size()));
    write_layout(settings, layout_of(figure));
    write_axes(settings, figure);
    write_contents(settings, plotdata, figure);
    write_atomically(plotdata / (figure.name + ".gp"), settings.text());
}

}  // namespace kreisel
