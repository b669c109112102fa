// SPDX-License-Identifier: BSD-3-Clause
#include "methods/conditions/numeric_tableau.hpp"

#include <stdexcept>

#include "methods/conditions/exact_text.hpp"

namespace kreisel::orders {

Rational exact(const Coefficient& coefficient) {
    if (coefficient.digits) return read_exact(coefficient.digits);
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
