// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/panel_kind.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plots/figures/alike.hpp"
#include "plots/figures/layout.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

std::vector<std::string> names_of_curves(const PanelFigure& figure) {
    std::vector<std::string> names;
    for (const Panel& panel : figure.panels) {
        for (const Curve& curve : panel.curves) {
            const bool known = std::find(names.begin(), names.end(), curve.name) != names.end();
            if (!known && !curve.name.empty()) { names.push_back(curve.name); }
        }
    }
    return names;
}

void require_curve(const std::string& name, const std::string& key, const std::vector<std::string>& names,
                   const std::string& figure) {
    if (std::find(names.begin(), names.end(), name) != names.end()) { return; }
    const std::string nearest = nearest_name(name, names);
    throw FigureError(fmt::format("{}: \"{}\" names \"{}\", which is none of its curves ({}){}", figure, key, name,
                                  fmt::join(names, "; "),
                                  nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
}

// Those that are named first, in that order.
void sort_curves(std::vector<Curve>& curves, const std::vector<std::string>& order) {
    const auto place = [&](const Curve& curve) { return std::find(order.begin(), order.end(), curve.name); };
    std::stable_sort(curves.begin(), curves.end(), [&](const Curve& a, const Curve& b) { return place(a) < place(b); });
}

bool has_positive_range(const std::optional<std::array<double, 2>>& range) { return !range || range->front() > 0; }

}  // namespace

std::string PanelKind::label_of(const std::string& curve) const {
    const auto given = legend.find(curve);
    return enhanced_escape(given == legend.end() ? curve : given->second);
}

PanelFigure PanelKind::panels(const Results& results) const {
    PanelFigure figure = make_panels(results);
    add_overlays(overlays, figure);
    figure.font_size = font_size;
    if (width) { figure.width = *width / mm_per_cm; }
    if (height) { figure.axes_height = *height / mm_per_cm; }
    const auto names = names_of_curves(figure);
    for (const auto& [curve, label] : legend) { require_curve(curve, "legend", names, name); }
    for (const std::string& first : order) { require_curve(first, "order", names, name); }
    for (Panel& panel : figure.panels) {
        sort_curves(panel.curves, order);
        if (!x_scale.empty()) { panel.log_x = x_scale == "log"; }
        if (!y_scale.empty()) { panel.log_y = y_scale == "log"; }
        panel.x_range = x_range, panel.y_range = y_range;
        if ((panel.log_x && !has_positive_range(x_range)) || (panel.log_y && !has_positive_range(y_range))) {
            throw FigureError(fmt::format("{}: a range of a logarithmic axis begins above 0", name));
        }
    }
    figure.panels = each_look_once(std::move(figure.panels));
    if (const TooWide wide = too_wide_label(figure); wide.curve != nullptr) {
        throw FigureError(
            fmt::format("{}: the legend \"{}\" takes {:.0f} mm of {:.0f} mm; shorter texts (\"legend\"), a smaller "
                        "\"font_size\", or fewer "
                        "\"columns\" make it fit",
                        name, wide.curve->label, mm_per_cm * wide.width, mm_per_cm * wide.space));
    }
    return figure;
}

std::vector<FigureKey> look_keys() {
    const auto scale = figure_value::choice("scale", {"log", "linear"});
    return {
        figure_key("columns", &PanelKind::columns, figure_value::count(1, 4, "panels beside each other"),
                   "panels beside each other"),
        figure_key("x_range", &PanelKind::x_range, figure_value::range(), "what the x axis shows", "all that is drawn"),
        figure_key("y_range", &PanelKind::y_range, figure_value::range(), "what the y axis shows", "all that is drawn"),
        figure_key("x_scale", &PanelKind::x_scale, scale, "the scale of the x axis", "that of the kind"),
        figure_key("y_scale", &PanelKind::y_scale, scale, "the scale of the y axis", "that of the kind"),
        figure_key("width", &PanelKind::width, figure_value::page_width(),
                   "width of the figure, within which the legends must find space",
                   "a column for each of two panels beside each other, and more where a legend is longer"),
        figure_key("height", &PanelKind::height, figure_value::between(10, 250, "a height in mm"),
                   "height of the axes of a panel", "50 mm"),
        figure_key("font_size", &PanelKind::font_size, figure_value::between(4, 20, "a size in points"),
                   "size of letters on the page"),
        figure_key("legend", &PanelKind::legend, figure_value::texts("a label"),
                   "what curves are called, by their names in the legend", "names of what differs"),
        figure_key("order", &PanelKind::order, figure_value::names("the name of a curve"),
                   "curves that come first in the legend, by their names there", "as the cells were planned"),
        figure_key("overlay", &PanelKind::overlays, figure_value::overlays(), "curves beside those of the cells",
                   "none")};
}

}  // namespace kreisel
