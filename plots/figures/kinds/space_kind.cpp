// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/space_kind.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plots/figures/cells/select.hpp"
#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kinds/smooth_path.hpp"
#include "plots/figures/settings.hpp"
#include "records/reading/trajectory_table.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

constexpr double space_width = 8.5;  // cm

struct SpaceBox {
    Point3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    void add(const Point3& point) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], point[i]);
            high[i] = std::max(high[i], point[i]);
        }
    }
    /// A cube about the same centre, so that all axes have the same scale and the drawing is not distorted.
    SpaceBox cube() const {
        double half = 0.05;
        for (std::size_t i = 0; i < 3; ++i) { half = std::max(half, 0.53 * (high[i] - low[i])); }
        SpaceBox result;
        for (std::size_t i = 0; i < 3; ++i) {
            const double middle = (low[i] + high[i]) / 2;
            result.low[i] = middle - half;
            result.high[i] = middle + half;
        }
        return result;
    }
};

// "x y z t" a line, an empty line between polylines.
std::string polyline_text(const std::vector<Point3>& points, const std::vector<double>& t) {
    std::string text;
    for (std::size_t k = 0; k < points.size(); ++k) {
        text += fmt::format("{} {} {} {}\n", points[k][0], points[k][1], points[k][2], t[std::min(k, t.size() - 1)]);
    }
    return text + "\n";
}

std::string settings_text(const SpaceKind& figure, const SpaceData& data) {
    Settings settings;
    settings.string("figure_name", figure.name);
    settings.string("figure_title", enhanced_escape(figure.title));
    settings.string("figure_note", enhanced_escape(figure.note));
    for (std::size_t i = 0; i < 3; ++i) {
        settings.number(fmt::format("low_{}", i + 1), data.low[i]);
        settings.number(fmt::format("high_{}", i + 1), data.high[i]);
    }
    settings.number("t_first", data.path.t.front());
    settings.number("t_last", data.path.t.back());
    settings.number("width_cm", data.width.value_or(space_width));
    settings.number("font_size", data.font_size);
    settings.number("elevation", data.view[0]);
    settings.number("azimuth", data.view[1]);
    return settings.text();
}

std::vector<Point3> velocities_of_body(const TrajectoryTable& samples, const std::string& body) {
    std::vector<Point3> v;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto* column = samples.find(fmt::format("{}.v{}", body, i + 1));
        if (column == nullptr) { return {}; }
        v.resize(column->size());
        for (std::size_t k = 0; k < v.size(); ++k) { v[k][i] = (*column)[k]; }
    }
    return v;
}

}  // namespace

BodyPath path_of_body(const TrajectoryTable& samples, const std::string& body) {
    std::vector<const std::vector<double>*> columns = {samples.find("t")};
    for (int i = 1; i <= 3; ++i) { columns.push_back(samples.find(fmt::format("{}.x{}", body, i))); }
    for (int i = 1; i <= 3; ++i) {
        for (int j = 1; j <= 3; ++j) { columns.push_back(samples.find(fmt::format("{}.R{}{}", body, i, j))); }
    }
    for (const auto* column : columns) {
        if (column == nullptr || column->empty()) { throw FigureError("the trajectory lacks t, x or R of the body"); }
    }
    BodyPath path{*columns[0], {}, {}, velocities_of_body(samples, body)};
    for (std::size_t k = 0; k < path.t.size(); ++k) {
        path.x.push_back({(*columns[1])[k], (*columns[2])[k], (*columns[3])[k]});
        std::array<double, 9> R{};
        for (std::size_t i = 0; i < 9; ++i) { R[i] = (*columns[4 + i])[k]; }
        path.R.push_back(R);
    }
    return path;
}

SpaceData SpaceKind::data(const Results& results) const {
    const ResultRow row = selected_trajectory(*this, results);
    const TrajectoryTable table = samples_until(until, row);
    SpaceData drawn{.view = view, .path = path_of_body(table, body_of(*this, body, table))};
    drawn.lines = drawn_bodies(drawn.path, row, table);
    drawn.path = smooth_path(drawn.path);
    SpaceBox box;
    for (const Point3& x : drawn.path.x) { box.add(x); }
    for (const TimedLine& line : drawn.lines) {
        for (const Point3& point : line.points) { box.add(point); }
    }
    box = box.cube();
    drawn.low = box.low;
    drawn.high = box.high;
    if (width) { drawn.width = *width / mm_per_cm; }
    drawn.font_size = font_size;
    return drawn;
}

void SpaceKind::write(const Results& results, const std::filesystem::path& folder) const {
    const SpaceData drawn = data(results);
    const BodyPath& path = drawn.path;
    std::string lines;
    for (const TimedLine& line : drawn.lines) { lines += polyline_text(line.points, {line.t}); }
    std::vector<Point3> shadow = path.x;
    for (Point3& point : shadow) { point[2] = drawn.low[2]; }
    const auto file = [&](const char* ending) { return folder / "plotdata" / (name + ending); };
    make_folder(folder / "plotdata");
    write_atomically(file(".path.dat"), polyline_text(path.x, path.t));
    write_atomically(file(".shadow.dat"), polyline_text(shadow, path.t));
    write_atomically(file(".ends.dat"), polyline_text({path.x.front()}, {path.t.front()}) + "\n" +
                                            polyline_text({path.x.back()}, {path.t.back()}));
    if (!lines.empty()) { write_atomically(file(".tops.dat"), lines); }
    write_atomically(file(".gp"), settings_text(*this, drawn));
}

std::vector<FigureKey> space_keys() {
    return {
        figure_key("body", &SpaceKind::body, figure_value::text("the name of a body"), "which body", "the first"),
        figure_key("view", &SpaceKind::view, figure_value::numbers<2>("two angles in degrees, [elevation, azimuth]"),
                   "from where it is seen"),
        figure_key("until", &SpaceKind::until, figure_value::positive("a time greater than 0, s"), "up to which time",
                   "all"),
        figure_key("width", &SpaceKind::width, figure_value::page_width(), "width of the figure", "85 mm"),
        figure_key("font_size", &SpaceKind::font_size, figure_value::between(4, 20, "a size in points"),
                   "size of letters on the page")};
}

}  // namespace kreisel
