// SPDX-License-Identifier: BSD-3-Clause
//
// Exact coefficients, free of `Real`: rationals, or decimal digits for numbers without a short closed form.
#pragma once

#include <numeric>
#include <string>
#include <utility>

namespace kreisel {

/// A rational {numerator, denominator}, an integer, or a string of at least 36 digits.
struct Coefficient {
    long numerator = 0, denominator = 1;
    const char* digits = nullptr;

    constexpr Coefficient(int integer = 0) : numerator(integer) {}           // NOLINT: tableaus list these
    constexpr Coefficient(long p, long q) : numerator(p), denominator(q) {}  //
    constexpr Coefficient(const char* decimal) : digits(decimal) {}          // NOLINT
    constexpr bool is_zero() const { return !digits && numerator == 0; }
    bool operator==(const Coefficient& other) const {
        if (digits || other.digits) return digits && other.digits && std::string(digits) == other.digits;
        const auto lowest = [](const Coefficient& c) {  // products would overflow
            const long divisor = std::gcd(c.numerator, c.denominator) * (c.denominator < 0 ? -1 : 1);
            return std::pair(c.numerator / divisor, c.denominator / divisor);
        };
        return lowest(*this) == lowest(other);
    }
};

}  // namespace kreisel
