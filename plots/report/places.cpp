// SPDX-License-Identifier: BSD-3-Clause
#include "plots/report/places.hpp"

#include <fmt/format.h>

#include <cmath>

#include "plots/report/poses.hpp"
#include "records/json/lists.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

constexpr std::size_t most_points_of_path = 2000, most_points_of_lines = 8000;

std::string six_digits(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : "null"; }

template <class Numbers>
std::string digits_of_all(const Numbers& numbers) {
    return json_list(numbers, six_digits);
}

std::string points_json(const std::vector<Point3>& points) { return json_list(points, digits_of_all<Point3>); }

std::string map_json(const HeatMapData::Map& map) {
    const auto place = [](const HeatMapData::Place& one) {
        return fmt::format("[{},{},{}]", one.x, one.y, json_number(one.value));
    };
    return ObjectWriter().member("label", json_text(map.label)).member("places", json_list(map.places, place)).text();
}

// Every k-th instant of the lines, so that few enough points are left.
std::string lines_json(const std::vector<TimedLine>& lines) {
    std::size_t points = 0, instant = 0;
    for (const TimedLine& line : lines) { points += line.points.size(); }
    const std::size_t step = points / most_points_of_lines + 1;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > 0 && lines[i].t != lines[i - 1].t) { ++instant; }
        if (instant % step != 0) { continue; }
        texts.push_back(fmt::format("[{},{}]", six_digits(lines[i].t), points_json(lines[i].points)));
    }
    return json_list(texts, [](const std::string& text) { return text; });
}

}  // namespace

std::string heat_json(const HeatMapData& data) {
    ObjectWriter object;
    if (data.width) { object.member("width", json_number(*data.width)); }
    if (data.axes_height) { object.member("axes_height", json_number(*data.axes_height)); }
    return object.member("font_size", json_number(data.font_size))
        .member("x_label", json_text(data.x_label))
        .member("y_label", json_text(data.y_label))
        .member("x_values", json_value(data.x_values))
        .member("y_values", json_value(data.y_values))
        .member("log", data.log ? "true" : "false")
        .member("maps", json_list(data.maps, map_json))
        .text();
}

std::string space_json(const SpaceData& data) {
    std::vector<double> t;
    std::vector<Point3> path;
    for (const std::size_t i : thinned(data.path.t.size(), most_points_of_path)) {
        t.push_back(data.path.t[i]);
        path.push_back(data.path.x[i]);
    }
    ObjectWriter object;
    if (data.width) { object.member("width", json_number(*data.width)); }
    return object.member("font_size", json_number(data.font_size))
        .member("low", digits_of_all(data.low))
        .member("high", digits_of_all(data.high))
        .member("view", digits_of_all(data.view))
        .member("t", digits_of_all(t))
        .member("path", points_json(path))
        .member("lines", lines_json(data.lines))
        .text();
}

}  // namespace kreisel
