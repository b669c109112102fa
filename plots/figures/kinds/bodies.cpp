// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/files.hpp"

namespace kreisel {

namespace {

using Matrix = std::array<double, 9>;

Point3 turned(const Matrix& R, const Point3& u) {
    Point3 result{};
    for (std::size_t i = 0; i < 3; ++i) { result[i] = R[3 * i] * u[0] + R[3 * i + 1] * u[1] + R[3 * i + 2] * u[2]; }
    return result;
}

Point3 sum(const Point3& a, const Point3& b, double factor = 1) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Point3 cross(const Point3& a, const Point3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point3 unit(const Point3& a) {
    const double length = std::hypot(a[0], a[1], a[2]);
    return {a[0] / length, a[1] / length, a[2] / length};
}

// Two unit vectors across `axis`; the start is the coordinate axis farthest from it.
std::pair<Point3, Point3> across(const Point3& axis) {
    Point3 start{};
    const auto smallest =
        std::min_element(axis.begin(), axis.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    start[static_cast<std::size_t>(smallest - axis.begin())] = 1;
    const Point3 first = unit(cross(axis, start));
    return {first, unit(cross(axis, first))};
}

// The sampled states of one body.
struct BodyPath {
    std::vector<double> t;
    std::vector<Point3> x;
    std::vector<Matrix> R;
};

BodyPath read_path(const TrajectoryTable& table, const std::string& body) {
    std::vector<const std::vector<double>*> columns = {table.find("t")};
    for (int i = 1; i <= 3; ++i) { columns.push_back(table.find(fmt::format("{}.x{}", body, i))); }
    for (int i = 1; i <= 3; ++i) {
        for (int j = 1; j <= 3; ++j) { columns.push_back(table.find(fmt::format("{}.R{}{}", body, i, j))); }
    }
    for (const auto* column : columns) {
        if (column == nullptr || column->empty()) { throw FigureError("the trajectory lacks t, x or R of the body"); }
    }
    BodyPath path{*columns[0], {}, {}};
    for (std::size_t k = 0; k < path.t.size(); ++k) {
        path.x.push_back({(*columns[1])[k], (*columns[2])[k], (*columns[3])[k]});
        Matrix R{};
        for (std::size_t i = 0; i < 9; ++i) { R[i] = (*columns[4 + i])[k]; }
        path.R.push_back(R);
    }
    return path;
}

Point3 lever_of(const FigureSpec& spec, const ResultRow& row) {
    Point3 lever{};
    const JsonValue* parameter = row.parameters.find("lever");
    if (spec.lever) {
        lever = *spec.lever;
    } else if (parameter != nullptr && parameter->elements.size() == lever.size()) {
        for (std::size_t i = 0; i < lever.size(); ++i) { lever[i] = parameter->elements[i].number(); }
    } else {
        throw FigureError(
            fmt::format("{}: problem {} has no lever; give \"lever\" in the figure", spec.name, row.problem));
    }
    if (!(std::hypot(lever[0], lever[1], lever[2]) > 0)) { throw FigureError(spec.name + ": the lever is zero"); }
    return lever;
}

struct Box {
    Point3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    void add(const Point3& point) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], point[i]);
            high[i] = std::max(high[i], point[i]);
        }
    }
    /// A cube about the same centre, so that all axes have the same scale and the drawing is not distorted.
    Box cube() const {
        double half = 0.05;
        for (std::size_t i = 0; i < 3; ++i) { half = std::max(half, 0.53 * (high[i] - low[i])); }
        Box result;
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

std::string settings_text(const FigureSpec& spec, const Box& box, const BodyPath& path) {
    std::string text = fmt::format("figure_name = {}\nfigure_title = {}\n", gnuplot_quoted(spec.name),
                                   gnuplot_quoted(enhanced_escape(spec.title)));
    for (std::size_t i = 0; i < 3; ++i) {
        text += fmt::format("low_{0} = {1}\nhigh_{0} = {2}\n", i + 1, box.low[i], box.high[i]);
    }
    text += fmt::format("t_first = {}\nt_last = {}\n", path.t.front(), path.t.back());
    return text + fmt::format("elevation = {}\nazimuth = {}\n", spec.view[0], spec.view[1]);
}

// Sample indices of `count` instants, the first and the last sample among them.
std::vector<std::size_t> instants(std::size_t samples, long count) {
    std::vector<std::size_t> indices;
    const auto last = static_cast<double>(samples - 1);
    for (long i = 0; i < count; ++i) {
        const double part = count == 1 ? 0 : static_cast<double>(i) / static_cast<double>(count - 1);
        indices.push_back(static_cast<std::size_t>(std::lround(part * last)));
    }
    return indices;
}

}  // namespace

std::vector<std::vector<Point3>> drawn_top(const Point3& x, const std::array<double, 9>& R, const Point3& lever,
                                           double radius) {
    constexpr int segments = 48, generators = 6;
    const Point3 tip = sum(x, turned(R, lever), -1);
    const auto plane = across(lever);
    const auto rim_point = [&](double angle) {
        const auto& [e, f] = plane;
        Point3 body{};
        for (std::size_t i = 0; i < 3; ++i) { body[i] = radius * (std::cos(angle) * e[i] + std::sin(angle) * f[i]); }
        return sum(x, turned(R, body));
    };
    std::vector<std::vector<Point3>> lines = {{tip, sum(x, turned(R, lever), 0.25)}, {}, {x, rim_point(0)}};
    for (int i = 0; i <= segments; ++i) { lines[1].push_back(rim_point(2 * std::numbers::pi * i / segments)); }
    for (int i = 0; i < generators; ++i) { lines.push_back({tip, rim_point(2 * std::numbers::pi * i / generators)}); }
    return lines;
}

void write_bodies(const std::filesystem::path& plotdata, const FigureSpec& spec, const Results& results,
                  const std::filesystem::path& folder) {
    const ResultRow row = selected_trajectory(spec, results);
    const TrajectoryTable table = selected_samples(spec, row, folder);
    const BodyPath path = read_path(table, body_of(spec, table));
    Box box;
    for (const Point3& x : path.x) { box.add(x); }
    std::string tops;
    if (spec.kind == "motion") {
        for (const std::size_t k : instants(path.t.size(), spec.instants)) {
            for (const auto& line : drawn_top(path.x[k], path.R[k], lever_of(spec, row), spec.radius)) {
                for (const Point3& point : line) { box.add(point); }
                tops += polyline_text(line, {path.t[k]});
            }
        }
    }
    box = box.cube();
    std::vector<Point3> shadow = path.x;
    for (Point3& point : shadow) { point[2] = box.low[2]; }
    make_folder(plotdata);
    write_atomically(plotdata / (spec.name + ".path.dat"), polyline_text(path.x, path.t));
    write_atomically(plotdata / (spec.name + ".shadow.dat"), polyline_text(shadow, path.t));
    write_atomically(plotdata / (spec.name + ".ends.dat"), polyline_text({path.x.front()}, {path.t.front()}) + "\n" +
                                                               polyline_text({path.x.back()}, {path.t.back()}));
    if (spec.kind == "motion") { write_atomically(plotdata / (spec.name + ".tops.dat"), tops); }
    write_atomically(plotdata / (spec.name + ".gp"), settings_text(spec, box, path));
}

}  // namespace kreisel
