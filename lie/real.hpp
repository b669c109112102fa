// SPDX-License-Identifier: BSD-3-Clause
//
// `Real`, the one number type of all numerical code. Every file that mentions it is compiled once per precision, into
// the inline namespace KREISEL_PRECISION (`binary64` or `binary128`), so both object sets live in one program.
//
// Rules that no warning enforces: no floating literal that is not dyadic (write Real(1)/10, never 0.1), and calls of
// the mathematical functions unqualified (sqrt(x), never std::sqrt(x)), or quad silently becomes double.
#pragma once

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#ifndef KREISEL_QUAD
#error "KREISEL_QUAD must be 0 or 1 and KREISEL_PRECISION binary64 or binary128: see CMakeLists.txt"
#endif
#if KREISEL_QUAD
#include <boost/multiprecision/float128.hpp>
#endif
#ifdef __FAST_MATH__
#error "-ffast-math breaks isfinite, and with it every check for NaN"
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

#if KREISEL_QUAD
// Expression templates off: with them `auto` and the conditional operator keep references to dead temporaries.
using Real = boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;
using boost::multiprecision::isfinite;
#else
using Real = double;
using std::isfinite;
#endif

using std::abs;
using std::acos;
using std::atan2;
using std::cbrt;
using std::cos;
using std::frexp;
using std::ldexp;
using std::log2;
using std::max;
using std::min;
using std::pow;
using std::sin;
using std::sqrt;

/// Before a loop that writes over its input entry by entry or does not overlap it at all: vector instructions then need
/// no overlap check.
#define KREISEL_ELEMENTWISE _Pragma("GCC ivdep")

/// Unit round-off spacing of Real at 1.
inline const Real epsilon = std::numeric_limits<Real>::epsilon();

/// The power of two next below or equal to x > 0: a unit in which numbers keep all their bits.
inline Real power_of_two_below(const Real& x) {
    int exponent = 0;
    frexp(x, &exponent);
    return ldexp(Real(1), exponent - 1);
}

/// Circle constant, from arithmetic that is exact to the last bit in both precisions.
inline Real pi() { return acos(Real(-1)); }

inline double to_double(const Real& x) { return static_cast<double>(x); }

/// The decimal number that `x` prints as: data written as -4.61538 mean that decimal in every precision.
inline Real decimal(double x) {
#if KREISEL_QUAD
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text - 1, x).ptr;
    *end = '\0';
    return Real(static_cast<const char*>(text));
#else
    return x;
#endif
}

/// Shortest text that reads back as x (double), or 36 significant digits (quad).
std::string to_text(const Real& x);

/// Reads what to_text wrote, or any decimal number. Throws std::invalid_argument.
Real from_text(const std::string& text);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
