// SPDX-License-Identifier: BSD-3-Clause
//
// A number as results hold it, and how far apart two of them are.
#pragma once

#include <string>

namespace kreisel {

/// A bare number of a result line is a double; a number in quotes is a decimal of a quad run.
struct RecordedNumber {
    double value = 0;  ///< rounded to double
    std::string quad;  ///< all digits of a quad number; empty for a double

    /// As the file has it, up to the way a double is written.
    std::string text() const;
};

/// The decimal of a quad number. Throws std::invalid_argument if `decimal` is not a finite number.
RecordedNumber quad_number(const std::string& decimal);

/// How far a is from b. All zero where they are equal; 0 and -0 are.
struct NumberDistance {
    double absolute = 0;  ///< |a - b|
    double relative = 0;  ///< |a - b| / max(|a|, |b|)
    /// |a - b| over the spacing of floating-point numbers just below max(|a|, |b|): 1 for neighbours. Of 113 bits where
    /// both are quad, otherwise of 53.
    double ulps = 0;

    bool any() const { return ulps > 0; }
};

NumberDistance distance(const RecordedNumber& a, const RecordedNumber& b);

}  // namespace kreisel
