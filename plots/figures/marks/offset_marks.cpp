// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/marks/offset_marks.hpp"

#include <algorithm>
#include <cmath>

#include "plots/figures/layout.hpp"

namespace kreisel {

namespace {

constexpr int colours = 7;  // plots/gnuplot/style.gp
constexpr int marks_of_a_curve = 6;

int colour_of(const Curve& curve) { return (curve.style - 1) % colours; }

// Of the points of a curve along the x axis, from 0 to 1; beyond it of those that are not drawn.
std::vector<double> places_of(const Curve& curve, const Panel& panel) {
    const AxisRange range = axis_ranges(panel).first;
    std::vector<double> places;
    for (const Point& point : curve.points) {
        const double place = !is_drawable(point, panel) ? -1
                             : panel.log_x ? std::log(point.x / range.low) / std::log(range.high / range.low)
                                           : (point.x - range.low) / (range.high - range.low);
        places.push_back(place);
    }
    return places;
}

// Of the curve of this rank among `count`.
std::vector<std::size_t> marked_points(const std::vector<double>& places, std::size_t rank, std::size_t count) {
    std::vector<std::size_t> marked;
    const double distance = 1.0 / marks_of_a_curve;
    for (int k = 0; k < marks_of_a_curve; ++k) {
        const double wanted = (k + (static_cast<double>(rank) + 0.5) / static_cast<double>(count)) * distance;
        const auto away = [&](double place) { return std::abs(place - wanted); };
        const auto nearest =
            std::min_element(places.begin(), places.end(), [&](double a, double b) { return away(a) < away(b); });
        if (nearest == places.end() || away(*nearest) >= distance / 2) { continue; }
        marked.push_back(static_cast<std::size_t>(nearest - places.begin()));
    }
    return marked;
}

}  // namespace

std::vector<std::vector<std::size_t>> offset_marks(const Panel& panel) {
    const auto shares = [&](const Curve& curve) {
        return std::count_if(panel.curves.begin(), panel.curves.end(),
                             [&](const Curve& other) { return colour_of(other) == colour_of(curve); }) > 1;
    };
    const auto count = static_cast<std::size_t>(std::count_if(panel.curves.begin(), panel.curves.end(), shares));
    std::vector<std::vector<std::size_t>> all;
    std::size_t rank = 0;
    for (const Curve& curve : panel.curves) {
        all.push_back(shares(curve) ? marked_points(places_of(curve, panel), rank++, count)
                                    : std::vector<std::size_t>());
    }
    return all;
}

}  // namespace kreisel
