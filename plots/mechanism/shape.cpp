// SPDX-License-Identifier: BSD-3-Clause
#include "plots/mechanism/shape.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace kreisel {

namespace {

using Rows = std::array<Vector3, 3>;

// A <- J^T A J and V <- V J, with the rotation J in the plane (p, q) that makes A_pq zero.
void rotate(Rows& A, Rows& V, std::size_t p, std::size_t q) {
    const double angle = std::atan2(2 * A[p][q], A[q][q] - A[p][p]) / 2;
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turn = [&](double& a, double& b) { std::tie(a, b) = std::pair(c * a - s * b, s * a + c * b); };
    for (std::size_t k = 0; k < 3; ++k) { turn(A[k][p], A[k][q]); }
    for (std::size_t k = 0; k < 3; ++k) { turn(A[p][k], A[q][k]); }
    for (std::size_t k = 0; k < 3; ++k) { turn(V[k][p], V[k][q]); }
}

Vector3 cross_product(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double edge(double square) { return std::sqrt(std::max(square, 0.0)); }

// The principal axes with the k-th one last.
std::array<Vector3, 3> ending_with(const PrincipalMoments& principal, std::size_t k) {
    return {principal.axes[(k + 1) % 3], principal.axes[(k + 2) % 3], principal.axes[k]};
}

BodyShape solid(const PrincipalMoments& principal, double mass) {
    const Vector3& J = principal.values;
    const double largest = *std::max_element(J.begin(), J.end());
    const auto gap = [&](std::size_t k) { return std::abs(J[(k + 1) % 3] - J[(k + 2) % 3]) / largest; };
    std::size_t axis = 0;
    for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) { axis = gap(k) < gap(axis) ? k : axis; }
    constexpr double equal = 1e-6;
    const double others = (J[(axis + 1) % 3] + J[(axis + 2) % 3]) / 2;
    if (gap(axis) < equal && std::abs(J[axis] - others) < equal * largest) {
        const double diameter = 2 * edge(5 * others / (2 * mass));
        return {BodyShape::Kind::sphere, {diameter, diameter, diameter}, principal.axes};
    }
    if (gap(axis) < equal) {
        const double radius = edge(2 * J[axis] / mass), height = edge(12 * others / mass - 3 * radius * radius);
        return {BodyShape::Kind::cylinder, {2 * radius, 2 * radius, height}, ending_with(principal, axis)};
    }
    Vector3 edges{};
    for (std::size_t i = 0; i < 3; ++i) { edges[i] = edge(6 * (J[(i + 1) % 3] + J[(i + 2) % 3] - J[i]) / mass); }
    return {BodyShape::Kind::box, edges, principal.axes};
}

// Right-handed axes with this direction as the last; the first is across the body axis that is least along it.
std::array<Vector3, 3> ending_with_direction(const Vector3& direction) {
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    Vector3 last{}, least{};
    for (std::size_t i = 0; i < 3; ++i) { last[i] = direction[i] / length; }
    const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
    least[static_cast<std::size_t>(std::min_element(last.begin(), last.end(), smaller) - last.begin())] = 1;
    Vector3 first = cross_product(least, last);
    const double across = std::hypot(first[0], first[1], first[2]);
    for (double& part : first) { part /= across; }
    return {first, cross_product(last, first), last};
}

BodyShape given_shape(const ShapeData& given) {
    const Vector3 third = {0, 0, 1};
    if (given.size) { return {BodyShape::Kind::box, *given.size, {Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
    constexpr double slenderness = 50;  // of a rod, length over radius
    const double length = given.length.value_or(0), diameter = 2 * given.radius.value_or(length / slenderness);
    const auto axes = ending_with_direction(given.axis.value_or(third));
    if (!given.length) { return {BodyShape::Kind::sphere, {diameter, diameter, diameter}, axes}; }
    return {BodyShape::Kind::cylinder, {diameter, diameter, length}, axes};
}

}  // namespace

PrincipalMoments principal_moments(const Matrix3& symmetric) {
    Rows A{}, V{};
    for (std::size_t i = 0; i < 9; ++i) { A[i / 3][i % 3] = symmetric[i]; }
    for (std::size_t i = 0; i < 3; ++i) { V[i][i] = 1; }
    for (int sweep = 0; sweep < 30; ++sweep) {
        for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
            if (A[p][q] != 0) { rotate(A, V, p, q); }
        }
    }
    PrincipalMoments principal;
    for (std::size_t k = 0; k < 3; ++k) {
        principal.values[k] = A[k][k];
        principal.axes[k] = {V[0][k], V[1][k], V[2][k]};
    }
    principal.axes[2] = cross_product(principal.axes[0], principal.axes[1]);
    return principal;
}

BodyShape shape_of(const BodyGeometry& body, const Shapes& shapes) {
    const auto shape = shapes.find(body.name);
    return shape == shapes.end() ? shape_of(body) : given_shape(shape->second);
}

BodyShape shape_of(const BodyGeometry& body) {
    const PrincipalMoments principal = principal_moments(body.inertia);
    const bool positive =
        std::all_of(principal.values.begin(), principal.values.end(), [](double value) { return value > 0; });
    if (!(body.mass > 0) || !std::isfinite(body.mass) || !positive) { return {}; }
    BodyShape shape = solid(principal, body.mass);
    const double least = *std::max_element(shape.sizes.begin(), shape.sizes.end()) / 25;
    for (double& size : shape.sizes) { size = std::max(size, least); }
    return shape;
}

}  // namespace kreisel
