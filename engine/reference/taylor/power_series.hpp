// SPDX-License-Identifier: BSD-3-Clause
//
// Arithmetic of power series c_0 + c_1 s + c_2 s^2 + ..., one coefficient at a time: each function gives coefficient k
// from coefficients up to k of its arguments (`rate`: k + 1), so that a series may depend on itself through lower
// coefficients [griewankwalther2008, Chap. 13]. No function allocates.
#pragma once

#include <cstddef>
#include <vector>

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class T>
using Series = std::vector<T>;
using Scalars = Series<Real>;
using Vectors = Series<Vec3>;

inline Real real(std::size_t k) { return static_cast<int>(k); }

/// a(s) = sum a_k s^k.
inline Real value(const Scalars& a, const Real& s) {
    Real sum = 0;
    for (std::size_t k = a.size(); k-- > 0;) sum = sum * s + a[k];
    return sum;
}

/// sum over j = from ... k of op(a_j, b_{k-j}), added to `sum`.
template <class Sum, class A, class B, class Product>
Sum convolve(Sum sum, const Series<A>& a, const Series<B>& b, std::size_t k, Product op, std::size_t from = 0) {
    for (std::size_t j = from; j <= k; ++j) sum += op(a[j], b[k - j]);
    return sum;
}

/// (a b)_k.
inline Real product(const Scalars& a, const Scalars& b, std::size_t k) {
    return convolve(Real(0), a, b, k, [](const Real& x, const Real& y) -> Real { return x * y; });
}
inline Vec3 product(const Scalars& a, const Vectors& b, std::size_t k) {
    return convolve(Vec3(Vec3::Zero()), a, b, k, [](const Real& x, const Vec3& y) -> Vec3 { return x * y; });
}
inline Vec3 product(const Series<Mat3>& a, const Vectors& b, std::size_t k) {
    return convolve(Vec3(Vec3::Zero()), a, b, k, [](const Mat3& x, const Vec3& y) -> Vec3 { return x * y; });
}
/// (a^T b)_k.
inline Vec3 transposed_product(const Series<Mat3>& a, const Vectors& b, std::size_t k) {
    return convolve(Vec3(Vec3::Zero()), a, b, k,
                    [](const Mat3& x, const Vec3& y) -> Vec3 { return x.transpose() * y; });
}
/// (a . b)_k.
inline Real dot(const Vectors& a, const Vectors& b, std::size_t k) {
    return convolve(Real(0), a, b, k, [](const Vec3& x, const Vec3& y) -> Real { return x.dot(y); });
}
/// (a x b)_k.
inline Vec3 cross(const Vectors& a, const Vectors& b, std::size_t k) {
    return convolve(Vec3(Vec3::Zero()), a, b, k, [](const Vec3& x, const Vec3& y) -> Vec3 { return x.cross(y); });
}

/// q_k of q = a / b, from q_0 ... q_{k-1}: q_k b_0 = a_k - sum_{j=1..k} b_j q_{k-j}.
template <class T>
T quotient(const Series<T>& a, const Scalars& b, const Series<T>& q, std::size_t k) {
    return convolve(
               a[k], b, q, k, [](const Real& x, const T& y) -> T { return -x * y; }, 1) /
           b[0];
}

/// r_k of r = sqrt(a), from r_0 ... r_{k-1}: 2 r_0 r_k = a_k - sum_{j=1..k-1} r_j r_{k-j}.
inline Real square_root(const Scalars& a, const Scalars& r, std::size_t k) {
    if (k == 0) return sqrt(a[0]);
    Real rest = a[k];
    for (std::size_t j = 1; j < k; ++j) rest -= r[j] * r[k - j];
    return rest / (2 * r[0]);
}

/// Coefficient k of the derivative.
template <class T>
T rate(const Series<T>& a, std::size_t k) {
    return real(k + 1) * a[k + 1];
}

/// 1 + A sin(W (t + s)) as a series in s.
inline void modulate(const Real& A, const Real& W, const Real& t, Scalars& series) {
    const Real phase = W * t, derivatives[] = {sin(phase), cos(phase), -sin(phase), -cos(phase)};
    Real factor = A;
    for (std::size_t k = 0; k < series.size(); factor *= W / real(++k)) series[k] = factor * derivatives[k % 4];
    series[0] += 1;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
