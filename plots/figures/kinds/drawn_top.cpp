// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/drawn_top.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace kreisel {

namespace {

Point3 turned(const std::array<double, 9>& R, const Point3& u) {
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

}  // namespace kreisel
