// SPDX-License-Identifier: BSD-3-Clause
#include "plots/mechanism/outline.hpp"

#include <cmath>
#include <numbers>

#include "plots/mechanism/shape.hpp"

namespace kreisel {

namespace {

// The point whose coordinates along the axes of a shape are halves of its sizes times these.
Vector3 point_on(const BodyShape& shape, const Vector3& halves) {
    Vector3 point{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) { point[i] += shape.axes[k][i] * shape.sizes[k] / 2 * halves[k]; }
    }
    return point;
}

// About the axis k, at a height along it.
Polyline circle(const BodyShape& shape, std::size_t k, double height) {
    constexpr int segments = 36;
    Polyline line;
    for (int i = 0; i <= segments; ++i) {
        const double angle = 2 * std::numbers::pi * i / segments;
        Vector3 halves{};
        halves[k] = height;
        halves[(k + 1) % 3] = std::cos(angle);
        halves[(k + 2) % 3] = std::sin(angle);
        line.push_back(point_on(shape, halves));
    }
    return line;
}

std::vector<Polyline> box_edges(const BodyShape& shape) {
    std::vector<Polyline> lines;
    for (std::size_t k = 0; k < 3; ++k) {
        for (const double a : {-1.0, 1.0}) {
            for (const double b : {-1.0, 1.0}) {
                Vector3 from{}, to{};
                from[k] = -1, to[k] = 1;
                from[(k + 1) % 3] = to[(k + 1) % 3] = a;
                from[(k + 2) % 3] = to[(k + 2) % 3] = b;
                lines.push_back({point_on(shape, from), point_on(shape, to)});
            }
        }
    }
    return lines;
}

std::vector<Polyline> edges_of(const BodyShape& shape) {
    switch (shape.kind) {
        case BodyShape::Kind::box:
            return box_edges(shape);
        case BodyShape::Kind::sphere:
            return {circle(shape, 0, 0), circle(shape, 1, 0), circle(shape, 2, 0)};
        case BodyShape::Kind::cylinder: {
            std::vector<Polyline> lines = {circle(shape, 2, -1), circle(shape, 2, 1)};
            for (const auto& [a, b] :
                 {std::pair(1.0, 0.0), std::pair(0.0, 1.0), std::pair(-1.0, 0.0), std::pair(0.0, -1.0)}) {
                lines.push_back({point_on(shape, {a, b, -1}), point_on(shape, {a, b, 1})});
            }
            return lines;
        }
        default:
            return {};
    }
}

}  // namespace

std::vector<Polyline> outline_of(const BodyGeometry& body, const Geometry& mechanism, const Shapes& shapes) {
    std::vector<Polyline> lines = edges_of(shape_of(body, shapes));
    for (const LinkGeometry& link : mechanism.links) {
        for (std::size_t side = 0; side < 2; ++side) {
            if (link.between[side] == body.name && link.points[side] != Vector3{}) {
                lines.push_back({{0, 0, 0}, link.points[side]});
            }
        }
    }
    return lines;
}

Polyline moved(const Polyline& line, const Vector3& x, const Matrix3& R) {
    Polyline result;
    for (const Vector3& p : line) {
        Vector3 point = x;
        for (std::size_t i = 0; i < 9; ++i) { point[i / 3] += R[i] * p[i % 3]; }
        result.push_back(point);
    }
    return result;
}

}  // namespace kreisel
