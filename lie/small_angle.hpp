// SPDX-License-Identifier: BSD-3-Clause
//
// The scalar functions of the rotation angle t that exp, dexp and their inverses need, as functions of s = t^2 so
// that no square root is taken at small angles. Each is a Horner series in s where the closed form cancels, and the
// closed form elsewhere; the tiers keep the error at a few ulp for t in [0, pi].
//
//   sinc(s)   = sin t / t                          = sum (-s)^k / (2k+1)!
//   cosc(s)   = (1 - cos t) / t^2                  = sum (-s)^k / (2k+2)!
//   sincc(s)  = (t - sin t) / t^3                  = sum (-s)^k / (2k+3)!
//   cotc(s)   = (1 - (t/2) cot(t/2)) / t^2         = sum |B_{2k+2}| / (2k+2)! s^k,  |t| < 2 pi
// and the derivatives d/ds of cosc, sincc and cotc, which SE(3) needs.
//
// Traps: (1 - cos t)/t^2 as written loses 2e-11 at t = 1e-3, the direct cotc 35 ulp at t = 0.5, and its derivative
// 4 % at t = 0.01. Source: [hairer2006, Sec. IV.7], [iserles2000, Sec. 2.4]; the recursion for cotc below is the
// Riccati equation x y' = y - y^2 - x^2 of y = x cot x.
#pragma once

#include <array>
#include <cstddef>

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace series {

#if KREISEL_QUAD
inline constexpr std::size_t entire_terms = 16, entire_terms_wide = 26, cot_terms = 24, cot_terms_wide = 62;
inline constexpr std::size_t entire_terms_small = 10, cot_terms_small = 11;
#else
inline constexpr std::size_t entire_terms = 9, entire_terms_wide = 15, cot_terms = 11, cot_terms_wide = 30;
inline constexpr std::size_t entire_terms_small = 5, cot_terms_small = 5;
#endif

/// Squared angle up to which the fewest terms do, an eighth of a radian squared: accurate steps turn by less.
inline constexpr double small = 1.0 / 64;

/// Coefficients are made in 113 bits and rounded once: in double each is the correctly rounded one.
using Wide = __float128;
template <std::size_t n>
using Coefficients = std::array<Wide, n>;

/// (-1)^k / (2k + shift)!
template <std::size_t n>
constexpr Coefficients<n> alternating_factorials(int shift) {
    Coefficients<n> a{};
    Wide term = 1;
    for (int i = 2; i <= shift; ++i) term /= i;
    for (std::size_t k = 0; k < n; ++k) {
        a[k] = term;
        const Wide m = static_cast<Wide>(2 * k) + shift;
        term /= -(m + 1) * (m + 2);
    }
    return a;
}

/// |B_{2k+2}| / (2k+2)!: with x cot x = 1 - sum e_k x^{2k}, (2k+1) e_k = [k = 1] + sum_{i+j=k} e_i e_j, all positive.
template <std::size_t n>
constexpr Coefficients<n> bernoulli_over_factorial() {
    std::array<Wide, n + 1> e{};
    Coefficients<n> a{};
    Wide quarter_power = 1;
    for (std::size_t k = 1; k <= n; ++k) {
        Wide sum = k == 1 ? 1 : 0;
        for (std::size_t i = 1; i < k; ++i) sum += e[i] * e[k - i];
        e[k] = sum / static_cast<Wide>(2 * k + 1);
        quarter_power /= 4;
        a[k - 1] = e[k] * quarter_power;
    }
    return a;
}

/// Coefficients of the derivative d/ds.
template <std::size_t n>
constexpr Coefficients<n - 1> derivative(const Coefficients<n>& a) {
    Coefficients<n - 1> b{};
    for (std::size_t k = 0; k + 1 < n; ++k) b[k] = a[k + 1] * static_cast<Wide>(k + 1);
    return b;
}

template <std::size_t n>
constexpr std::array<double, n> rounded(const Coefficients<n>& a) {
    std::array<double, n> b{};
    for (std::size_t k = 0; k < n; ++k) b[k] = static_cast<double>(a[k]);
    return b;
}

inline constexpr auto bernoulli = bernoulli_over_factorial<cot_terms_wide>();

#if KREISEL_QUAD
template <std::size_t n>
constexpr Coefficients<n> stored(const Coefficients<n>& a) {
    return a;
}
#else
template <std::size_t n>
constexpr std::array<double, n> stored(const Coefficients<n>& a) {
    return rounded(a);
}
#endif

inline constexpr auto sinc = stored(alternating_factorials<entire_terms>(1));
inline constexpr auto cosc = stored(alternating_factorials<entire_terms>(2));
inline constexpr auto sincc = stored(alternating_factorials<entire_terms_wide>(3));
inline constexpr auto cosc_ds = stored(derivative(alternating_factorials<entire_terms_wide + 1>(2)));
inline constexpr auto sincc_ds = stored(derivative(alternating_factorials<entire_terms_wide + 1>(3)));
inline constexpr auto cotc = stored(bernoulli);
inline constexpr auto cotc_ds = stored(derivative(bernoulli));

/// sum_{k < n} a_k s^k.
template <std::size_t n, class Array>
inline Real horner(const Array& a, const Real& s) {
    Real sum = Real(a[n - 1]);
    for (std::size_t k = n - 1; k-- > 0;) sum = sum * s + Real(a[k]);
    return sum;
}

}  // namespace series

inline Real sinc(const Real& s) {
    if (s <= series::small) return series::horner<series::entire_terms_small>(series::sinc, s);
    if (s <= 1) return series::horner<series::entire_terms>(series::sinc, s);
    const Real t = sqrt(s);
    return sin(t) / t;
}

inline Real cosc(const Real& s) {
    if (s <= series::small) return series::horner<series::entire_terms_small>(series::cosc, s);
    if (s <= 1) return series::horner<series::entire_terms>(series::cosc, s);
    const Real half_sine = sin(sqrt(s) / 2);
    return 2 * half_sine * half_sine / s;
}

inline Real sincc(const Real& s) {
    if (s <= 1) return series::horner<series::entire_terms>(series::sincc, s);
    if (s <= 9) return series::horner<series::entire_terms_wide>(series::sincc, s);
    const Real t = sqrt(s);
    return (t - sin(t)) / (s * t);
}

/// d cosc / ds = (sinc - 2 cosc) / (2 s).
inline Real cosc_ds(const Real& s) {
    if (s <= 1) return series::horner<series::entire_terms>(series::cosc_ds, s);
    if (s <= 9) return series::horner<series::entire_terms_wide>(series::cosc_ds, s);
    return (sinc(s) - 2 * cosc(s)) / (2 * s);
}

/// d sincc / ds = (cosc - 3 sincc) / (2 s).
inline Real sincc_ds(const Real& s) {
    if (s <= 1) return series::horner<series::entire_terms>(series::sincc_ds, s);
    if (s <= 9) return series::horner<series::entire_terms_wide>(series::sincc_ds, s);
    return (cosc(s) - 3 * sincc(s)) / (2 * s);
}

inline Real cotc(const Real& s) {
    if (s <= series::small) return series::horner<series::cot_terms_small>(series::cotc, s);
    if (s <= 1) return series::horner<series::cot_terms>(series::cotc, s);
    if (s <= 9) return series::horner<series::cot_terms_wide>(series::cotc, s);
    const Real x = sqrt(s) / 2;
    return (1 - x * cos(x) / sin(x)) / s;
}

/// d cotc / ds = ((1/sin^2 x - cot x / x) / 8 - cotc) / s with x = t/2.
inline Real cotc_ds(const Real& s) {
    if (s <= 1) return series::horner<series::cot_terms>(series::cotc_ds, s);
    if (s <= 9) return series::horner<series::cot_terms_wide - 1>(series::cotc_ds, s);
    const Real x = sqrt(s) / 2, sine = sin(x);
    return ((1 / (sine * sine) - cos(x) / (sine * x)) / 8 - cotc(s)) / s;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
