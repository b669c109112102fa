// SPDX-License-Identifier: BSD-3-Clause
#include "plots/report/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plots/figures/kind.hpp"
#include "plots/figures/kinds/panel_kind.hpp"
#include "plots/figures/marks/offset_marks.hpp"
#include "plots/figures/spec.hpp"
#include "plots/report/places.hpp"
#include "records/json/lists.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

std::string number_or_null(double value) { return std::isfinite(value) ? json_number(value) : "null"; }

std::string flag_json(bool value) { return value ? "true" : "false"; }

std::string coordinates_json(const std::vector<Point>& points, double Point::*coordinate) {
    return json_list(points, [=](const Point& point) { return number_or_null(point.*coordinate); });
}

// Of those points of a curve that a law was fitted to.
std::string fitted_json(const Curve& curve) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const auto same = [&](const Point& point) {
            return point.x == curve.points[i].x && point.y == curve.points[i].y;
        };
        if (std::any_of(curve.fitted.begin(), curve.fitted.end(), same)) { indices.push_back(i); }
    }
    return fmt::format("[{}]", fmt::join(indices, ","));
}

std::string curve_json(const Curve& curve, const std::string& x, const std::vector<std::size_t>& marked) {
    ObjectWriter object;
    object.member("label", json_text(curve.label))
        .member("style", std::to_string(curve.style))
        .member("x", x)
        .member("y", coordinates_json(curve.points, &Point::y));
    if (!curve.fitted.empty()) { object.member("fitted", fitted_json(curve)); }
    if (!marked.empty()) { object.member("marked", fmt::format("[{}]", fmt::join(marked, ","))); }
    return object.text();
}

// Of a panel. Where a curve has the x of an earlier one, which all samples at the same times have, its `x` is the index
// of that curve.
std::string curves_json(const Panel& panel) {
    const auto marked = offset_marks(panel);
    std::map<std::string, std::string> first;
    std::size_t count = 0;
    return json_list(panel.curves, [&](const Curve& curve) {
        const std::string x = coordinates_json(curve.points, &Point::x);
        const auto [known, is_new] = first.emplace(x, std::to_string(count));
        return curve_json(curve, is_new ? x : known->second, marked[count++]);
    });
}

std::string guide_json(const std::vector<Point>& guide) {
    return fmt::format("{{\"x\":{},\"y\":{}}}", coordinates_json(guide, &Point::x), coordinates_json(guide, &Point::y));
}

std::string mark_json(const Mark& mark) {
    return ObjectWriter()
        .member("x", number_or_null(mark.at.x))
        .member("y", number_or_null(mark.at.y))
        .member("text", json_text(mark.text))
        .text();
}

// A figure: the members that all have, and more.
std::string figure_json(const Figure& figure, const ObjectWriter& more) {
    const std::string rest = more.open_text().substr(1);
    ObjectWriter object;
    object.member("name", json_text(figure.name))
        .member("kind", json_text(figure.kind))
        .member("title", json_text(figure.title));
    return object.open_text() + (rest.empty() ? "" : ",") + rest + "}";
}

std::string range_json(const std::array<double, 2>& range) {
    return fmt::format("[{},{}]", json_number(range.front()), json_number(range.back()));
}

ObjectWriter panels_json(const Figure& figure, const PanelFigure& drawn) {
    const FigureKind* kind = find_figure_kind(figure.kind);
    ObjectWriter object;
    if (drawn.width) { object.member("width", json_number(*drawn.width)); }
    object.member("axes_height", json_number(drawn.axes_height))
        .member("font_size", json_number(drawn.font_size))
        .member("columns", std::to_string(drawn.columns))
        .member("marks", flag_json(kind != nullptr && kind->script != "lines"))
        .member("lines", flag_json(kind == nullptr || kind->script != "points"))
        .member("panels", json_list(drawn.panels, [](const Panel& panel) { return json_value(panel); }));
    return object;
}

std::string drawn_json(const Figure& figure, const Results& results, std::vector<std::string>& not_drawn) {
    const auto* heat = dynamic_cast<const HeatMapKind*>(&figure);
    const auto* space = dynamic_cast<const SpaceKind*>(&figure);
    try {
        if (heat != nullptr) {
            return figure_json(figure, ObjectWriter().member("heat", heat_json(heat->data(results))));
        }
        if (space != nullptr) {
            return figure_json(figure, ObjectWriter().member("space", space_json(space->data(results))));
        }
        const auto& kind = dynamic_cast<const PanelKind&>(figure);
        return figure_json(figure, panels_json(figure, kind.panels(results)));
    } catch (const FigureError& error) {
        not_drawn.emplace_back(error.what());
        return figure_json(figure, ObjectWriter().member("not_drawn", json_text(error.what())));
    }
}

}  // namespace

std::string json_value(const Panel& panel) {
    ObjectWriter object;
    if (panel.x_range) { object.member("x_range", range_json(*panel.x_range)); }
    if (panel.y_range) { object.member("y_range", range_json(*panel.y_range)); }
    return object.member("title", json_text(panel.title))
        .member("x_label", json_text(panel.x_label))
        .member("y_label", json_text(panel.y_label))
        .member("log_x", flag_json(panel.log_x))
        .member("log_y", flag_json(panel.log_y))
        .member("from_zero", flag_json(panel.from_zero))
        .member("curves", curves_json(panel))
        .member("guides", json_list(panel.guides, guide_json))
        .member("marks", json_list(panel.marks, mark_json))
        .text();
}

ReportFigures report_figures(const Results& results) {
    ReportFigures all;
    std::string list;
    try {
        for (const auto& figure : figures_of(results)) {
            list += (list.empty() ? "" : ",") + drawn_json(*figure, results, all.not_drawn);
        }
    } catch (const FigureError& error) { all.not_drawn.emplace_back(error.what()); }
    all.json = "[" + list + "]";
    return all;
}

}  // namespace kreisel
