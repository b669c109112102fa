// SPDX-License-Identifier: BSD-3-Clause
//
// Explicit tableaus in the arithmetic a test needs.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "methods/tableaus/tableau.hpp"

namespace kreisel::orders {

using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
/// 100 decimal digits. Expression templates are off, as Eigen wants them.
using Float100 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

template <class T>
struct NumericTableau {
    std::vector<std::vector<T>> a;  ///< row i holds a_i1 ... a_i,i-1
    std::vector<T> b;
    std::vector<T> b_hat = {};  ///< of a pair
};

/// A coefficient as the number that is written: decimals are rationals too.
Rational exact(const Coefficient& coefficient);
NumericTableau<Rational> exact(const Tableau& tableau);
NumericTableau<Float100> in_100_digits(const NumericTableau<Rational>& tableau);
/// How well coefficients can satisfy conditions: exactly, or to the digits written.
Rational rounding(bool digits);
/// How well the declared coefficients can satisfy conditions: exactly, or to the digits written.
Rational rounding(const Tableau& tableau);

template <class T>
bool all_within(const std::vector<T>& residuals, const T& slack) {
    return std::all_of(residuals.begin(), residuals.end(), [&](const T& r) { return abs(r) <= slack; });
}

/// Calls f(coefficient) for every coefficient, rows of `a` first, b^ last.
template <class T, class F>
void each_coefficient(NumericTableau<T>& tableau, F f) {
    for (auto& row : tableau.a)
        for (auto& entry : row) f(entry);
    for (auto& weight : tableau.b) f(weight);
    for (auto& weight : tableau.b_hat) f(weight);
}

}  // namespace kreisel::orders
