// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/overlay/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/figure.hpp"

namespace kreisel {

namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();
constexpr long most_panels = 1000;
const std::string expected_points = "a list of points [x, y] with numbers, or null where the curve is interrupted";

nlohmann::ordered_json coordinate(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

std::optional<double> read_coordinate(const Node& node) {
    return node.json().is_null() ? std::optional(absent) : node.number();
}

std::optional<Point> read_point(const Node& node) {
    const auto entries = node.is_array() ? node.elements_or_self() : std::vector<Node>();
    if (entries.size() != 2) {
        node.mismatch(expected_points);
        return std::nullopt;
    }
    const auto x = read_coordinate(entries[0]), y = read_coordinate(entries[1]);
    return x && y ? std::optional(Point{*x, *y}) : std::nullopt;
}

std::vector<Point> read_points(const Node& node) {
    std::vector<Point> points;
    const auto entries = node.elements(expected_points);
    if (!entries) { return points; }
    if (entries->size() > most_overlay_points) {
        node.error(fmt::format("at most {} points", most_overlay_points), fmt::format("{}", entries->size()));
        return points;
    }
    for (const Node& entry : *entries) {
        if (const auto point = read_point(entry)) { points.push_back(*point); }
    }
    return points;
}

std::optional<Overlay> read_overlay(const Node& node) {
    if (!node.require_object("an object with \"label\" and \"points\", or \"file\", \"x\" and \"y\"")) {
        return std::nullopt;
    }
    node.only_keys({"label", "points", "panel"});
    const auto label = node.require("label", "a label");
    const auto points = node.require("points", expected_points);
    const auto panel = node.find("panel");
    Overlay overlay;
    if (label) { overlay.label = label->text("a label").value_or(""); }
    if (points) { overlay.points = read_points(*points); }
    if (panel) { overlay.panel = panel->count(1, most_panels, "the number of a panel").value_or(0); }
    return overlay;
}

nlohmann::ordered_json overlay_schema() {
    using Schema = nlohmann::ordered_json;
    const Schema text = {
        {"type", "string"}, {"minLength", 1}, {"maxLength", 200}, {"pattern", "^[^\\u0000-\\u001F\\u007F]*$"}};
    const Schema number = {{"type", {"number", "null"}}, {"minimum", -largest_number}, {"maximum", largest_number}};
    const Schema point = {{"type", "array"}, {"items", number}, {"minItems", 2}, {"maxItems", 2}};
    const Schema points = {{"type", "array"}, {"items", point}, {"minItems", 1}, {"maxItems", most_overlay_points}};
    const Schema panel = {{"type", "integer"}, {"minimum", 1}, {"maximum", most_panels}};
    const auto object = [](const Schema& properties, const Schema& required) {
        return Schema{
            {"type", "object"}, {"properties", properties}, {"additionalProperties", false}, {"required", required}};
    };
    const Schema written = object({{"label", text}, {"points", points}, {"panel", panel}}, {"label", "points"});
    Schema path = text;
    path["maxLength"] = 4096;
    const Schema in_file = object({{"label", text}, {"file", path}, {"x", text}, {"y", text}, {"panel", panel}},
                                  {"label", "file", "x", "y"});
    return {{"anyOf", {written, in_file}}};
}

}  // namespace

nlohmann::ordered_json json_of(const std::vector<Overlay>& overlays) {
    if (overlays.empty()) { return nullptr; }
    auto all = nlohmann::ordered_json::array();
    for (const Overlay& overlay : overlays) {
        auto points = nlohmann::ordered_json::array();
        for (const Point& point : overlay.points) { points.push_back({coordinate(point.x), coordinate(point.y)}); }
        all.push_back({{"label", overlay.label}, {"points", std::move(points)}});
        if (overlay.panel > 0) { all.back()["panel"] = overlay.panel; }
    }
    return all;
}

void add_overlays(const std::vector<Overlay>& overlays, PanelFigure& figure) {
    int style = 0;
    for (const Panel& panel : figure.panels) {
        for (const Curve& curve : panel.curves) { style = std::max(style, curve.style); }
    }
    for (const Overlay& overlay : overlays) {
        if (overlay.panel > std::ssize(figure.panels)) {
            throw FigureError(fmt::format("{}: overlay \"{}\" is for panel {}, and there are {}", figure.name,
                                          overlay.label, overlay.panel, figure.panels.size()));
        }
        ++style;
        for (long i = 0; i < std::ssize(figure.panels); ++i) {
            if (overlay.panel > 0 && overlay.panel != i + 1) { continue; }
            figure.panels[static_cast<std::size_t>(i)].curves.push_back(
                {enhanced_escape(overlay.label), overlay.points, style, {}, overlay.label});
        }
    }
}

namespace figure_value {

Type<std::vector<Overlay>> overlays() {
    return {
        "an object with \"label\", and \"points\" or \"file\", \"x\" and \"y\" (titles of columns of a CSV file), or a "
        "list of them; \"panel\" is the number of one panel",
        [] {
            const auto one = overlay_schema();
            return nlohmann::ordered_json{
                {"anyOf", {one, {{"type", "array"}, {"items", one}, {"minItems", 1}, {"uniqueItems", true}}}}};
        },
        [](const Node& node) -> std::optional<std::vector<Overlay>> {
            std::vector<Overlay> all;
            const auto entries = node.is_array() ? node.distinct_elements("a list of at least one overlay", "overlay")
                                                 : std::vector<Node>{node};
            for (const Node& entry : entries) {
                if (auto one = read_overlay(entry)) { all.push_back(std::move(*one)); }
            }
            return all;
        }};
}

}  // namespace figure_value

}  // namespace kreisel
