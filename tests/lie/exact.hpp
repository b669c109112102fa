// SPDX-License-Identifier: BSD-3-Clause
//
// Factorials and Bernoulli numbers in exact rational arithmetic, from their definitions.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "lie/real.hpp"

namespace exact {

using Rational = boost::multiprecision::cpp_rational;
using Decimal = boost::multiprecision::cpp_bin_float_100;

inline Rational factorial(int n) {
    Rational product = 1;
    for (int i = 2; i <= n; ++i) product *= i;
    return product;
}

/// B_0 ... B_n with B_1 = -1/2: sum_{j <= m} binomial(m + 1, j) B_j = 0 for m >= 1.
inline std::vector<Rational> bernoulli_numbers(int n) {
    std::vector<Rational> B = {1};
    for (int m = 1; m <= n; ++m) {
        Rational sum = 0, binomial = 1;
        for (int j = 0; j < m; ++j) {
            sum += binomial * B[static_cast<std::size_t>(j)];
            binomial = binomial * (m + 1 - j) / (j + 1);
        }
        B.push_back(-sum / (m + 1));
    }
    return B;
}

inline Decimal decimal(const Rational& x) { return Decimal(numerator(x)) / Decimal(denominator(x)); }

/// The value of a stored number without rounding: a quad number is the sum of three doubles.
template <class Number>
Decimal decimal_of(const Number& x) {
    const double high = static_cast<double>(x), middle = static_cast<double>(x - high);
    return Decimal(high) + Decimal(middle) + Decimal(static_cast<double>(x - high - middle));
}

/// Nearest Real, to its last bit but one.
inline kreisel::Real real(const Decimal& x) {
    const double high = x.convert_to<double>();
    const Decimal rest = x - Decimal(high);
    const double middle = rest.convert_to<double>();
    return kreisel::Real(high) + (kreisel::Real(middle) + kreisel::Real((rest - Decimal(middle)).convert_to<double>()));
}

/// (-1)^p B_p / p!, the coefficients of the left-trivialised dexpinv.
inline std::vector<Decimal> left_coefficients(int n) {
    const auto B = bernoulli_numbers(n);
    std::vector<Decimal> c;
    for (int p = 0; p <= n; ++p)
        c.push_back(decimal(B[static_cast<std::size_t>(p)] / factorial(p)) * (p % 2 == 0 ? 1 : -1));
    return c;
}

}  // namespace exact
