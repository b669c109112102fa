// SPDX-License-Identifier: BSD-3-Clause
//
// Exact numbers as texts: whole ones, fractions and decimals, "-1", "-25/108", "0.25".
#pragma once

#include <deque>
#include <string>

#include "methods/conditions/numeric_tableau.hpp"

namespace kreisel::orders {

/// Throws std::invalid_argument, which says what was expected.
Rational read_exact(const std::string& text);

/// The number as methods take coefficients: integers as written where they are short, so that it rounds as one of a
/// method of ours does, else decimals: 60 of a fraction. These are kept in `digits`, which must outlive it.
Coefficient read_coefficient(const std::string& text, std::deque<std::string>& digits);

/// Whether `text` is a decimal of at least 40 digits, which may be the rounded value of a number without a shorter
/// form.
bool is_rounded(const std::string& text);

}  // namespace kreisel::orders
