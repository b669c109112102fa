// SPDX-License-Identifier: BSD-3-Clause
//
// Arithmetic of power series against known series and against values of the functions they represent.
#include "engine/reference/taylor/power_series.hpp"

#include <catch2/catch.hpp>

using namespace kreisel;

namespace {

constexpr std::size_t terms = 24;
const Real round_off("1e-30");

/// Series with decreasing coefficients, so that values at s = 1/4 are exact to round-off after many terms.
Scalars scalars(int seed) {
    Scalars c(3 * terms);
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = cos(Real(seed) + real(k) * seed) / real(k + 1);
    return c;
}
Vectors vectors(int seed) {
    Vectors c;
    for (std::size_t k = 0; k < 3 * terms; ++k)
        c.emplace_back(scalars(seed)[k], scalars(seed + 1)[k], scalars(seed + 2)[k]);
    return c;
}
Series<Mat3> matrices(int seed) {
    Series<Mat3> c(3 * terms);
    for (std::size_t k = 0; k < c.size(); ++k)
        for (int i = 0; i < 3; ++i) c[k].col(i) = vectors(seed + 3 * i)[k];
    return c;
}

template <class T>
T value(const Series<T>& c, const Real& s) {
    T sum = c.back();
    for (std::size_t k = c.size() - 1; k-- > 0;) sum = sum * s + c[k];
    return sum;
}
/// The series that `coefficient(k)` gives, as a value.
template <class F>
auto value_of(F coefficient, const Real& s) {
    Series<decltype(coefficient(0))> c;
    for (std::size_t k = 0; k < 3 * terms; ++k) c.push_back(coefficient(k));
    return value(c, s);
}

const Real s = Real(1) / 4;

}  // namespace

TEST_CASE("products of series have the product of the values") {
    const Scalars a = scalars(1), b = scalars(2);
    const Vectors u = vectors(3), v = vectors(5);
    const Series<Mat3> R = matrices(7);
    using K = std::size_t;
    CHECK(abs(value_of([&](K k) { return product(a, b, k); }, s) - value(a, s) * value(b, s)) < round_off);
    CHECK((value_of([&](K k) { return product(a, u, k); }, s) - value(a, s) * value(u, s)).norm() < round_off);
    CHECK(abs(value_of([&](K k) { return dot(u, v, k); }, s) - value(u, s).dot(value(v, s))) < round_off);
    CHECK((value_of([&](K k) { return cross(u, v, k); }, s) - value(u, s).cross(value(v, s))).norm() < round_off);
    CHECK((value_of([&](K k) { return product(R, u, k); }, s) - value(R, s) * value(u, s)).norm() < round_off);
    CHECK(
        (value_of([&](K k) { return transposed_product(R, u, k); }, s) - value(R, s).transpose() * value(u, s)).norm() <
        round_off);
}

TEST_CASE("quotients and square roots undo products") {
    Scalars a = scalars(1), b = scalars(2), q(terms), r(terms);
    b[0] = 3;
    const Vectors u = vectors(3);
    Vectors w(terms);
    const Scalars squares = [&] {
        Scalars c(terms);
        for (std::size_t k = 0; k < terms; ++k) c[k] = product(b, b, k);
        return c;
    }();
    for (std::size_t k = 0; k < terms; ++k) {
        q[k] = quotient(a, b, q, k), w[k] = quotient(u, b, w, k), r[k] = square_root(squares, r, k);
        CAPTURE(k);
        CHECK(abs(product(q, b, k) - a[k]) < round_off);
        CHECK((product(b, w, k) - u[k]).norm() < round_off);
        CHECK(abs(r[k] - b[k]) < round_off);
    }
}

TEST_CASE("series in closed form") {
    Scalars one(terms, Real(0)), linear = one, geometric = one, root = one;
    one[0] = linear[0] = 1, linear[1] = -1;
    Real binomial = 1;
    for (std::size_t k = 0; k < terms; ++k) {
        geometric[k] = quotient(one, linear, geometric, k), root[k] = square_root(linear, root, k);
        CHECK(geometric[k] == 1);                    // 1 / (1 - s)
        CHECK(abs(root[k] - binomial) < round_off);  // sqrt(1 - s)
        binomial *= (real(k) - Real(1) / 2) / real(k + 1);
    }
}

TEST_CASE("modulation and its rate") {
    const Real A = Real(1) / 3, W = 5, t = Real(2) / 7;
    Scalars m(2 * terms);
    modulate(A, W, t, m);
    CHECK(abs(value(m, s) - (1 + A * sin(W * (t + s)))) < round_off);
    Scalars slope;
    for (std::size_t k = 0; k + 1 < m.size(); ++k) slope.push_back(rate(m, k));
    CHECK(abs(value(slope, s) - A * W * cos(W * (t + s))) < 100 * round_off);
    modulate(0, 0, t, m);
    CHECK(m[0] == 1);
    CHECK(m[1] == 0);
}
