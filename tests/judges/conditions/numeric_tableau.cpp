// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/conditions/numeric_tableau.hpp"

#include <stdexcept>
#include <string>

namespace kreisel::orders {

namespace {

/// [-]digits.digits as numerator / 10^k.
Rational decimal_rational(std::string text) {
    const auto point = text.find('.');
    if (point == std::string::npos) return Rational(boost::multiprecision::cpp_int(text));
    const std::size_t decimals = text.size() - point - 1;
    text.erase(point, 1);
    const bool negative = text.front() == '-';
    text.erase(0, negative ? 1 : 0);
    text.erase(0, text.find_first_not_of('0'));  // a leading 0 would make it octal
    const boost::multiprecision::cpp_int numerator(text.empty() ? "0" : text);
    const Rational magnitude(
        numerator, boost::multiprecision::pow(boost::multiprecision::cpp_int(10), static_cast<unsigned>(decimals)));
    return negative ? -magnitude : magnitude;
}

}  // namespace

Rational exact(const Coefficient& coefficient) {
    if (coefficient.digits) return decimal_rational(coefficient.digits);
    if (coefficient.denominator == 0) throw std::invalid_argument("a coefficient has the denominator 0");
    return Rational(coefficient.numerator, coefficient.denominator);
}

NumericTableau<Rational> exact(const Tableau& tableau) {
    NumericTableau<Rational> numbers;
    for (const auto& row : tableau.a) {
        numbers.a.emplace_back();
        for (const auto& entry : row) numbers.a.back().push_back(exact(entry));
    }
    for (const auto& weight : tableau.b) numbers.b.push_back(exact(weight));
    for (const auto& weight : tableau.b_hat) numbers.b_hat.push_back(exact(weight));
    return numbers;
}

NumericTableau<Float100> in_100_digits(const NumericTableau<Rational>& tableau) {
    const auto converted = [](const std::vector<Rational>& row) {
        std::vector<Float100> numbers;
        for (const auto& entry : row) numbers.push_back(entry.convert_to<Float100>());
        return numbers;
    };
    NumericTableau<Float100> numbers;
    for (const auto& row : tableau.a) numbers.a.push_back(converted(row));
    numbers.b = converted(tableau.b);
    numbers.b_hat = converted(tableau.b_hat);
    return numbers;
}

Rational rounding(bool digits) {
    return digits ? Rational(1, boost::multiprecision::pow(boost::multiprecision::cpp_int(10), 40)) : Rational(0);
}

Rational rounding(const Tableau& tableau) {
    const auto has_digits = [](const std::vector<Coefficient>& row) {
        return std::any_of(row.begin(), row.end(), [](const Coefficient& entry) { return entry.digits != nullptr; });
    };
    return rounding(has_digits(tableau.b) || has_digits(tableau.b_hat) ||
                    std::any_of(tableau.a.begin(), tableau.a.end(), has_digits));
}

}  // namespace kreisel::orders
