// SPDX-License-Identifier: BSD-3-Clause
#include "methods/conditions/exact_text.hpp"

#include <limits>
#include <stdexcept>

namespace kreisel::orders {

namespace {

using Integer = boost::multiprecision::cpp_int;

constexpr std::size_t least_rounded_decimals = 40;

bool is_digits(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// Digits, which a leading 0 would make octal.
Integer integer(const std::string& digits) {
    const std::size_t first = digits.find_first_not_of('0');
    return first == std::string::npos ? Integer(0) : Integer(digits.substr(first));
}

/// |x| as it is written: whole numbers and decimals have the denominator 10^decimals.
struct WrittenFraction {
    bool negative = false;
    Integer numerator = 0, denominator = 1;
};

[[noreturn]] void refuse(const std::string& text) {
    throw std::invalid_argument(
        "expected a whole number, a fraction or a decimal (\"-1\", \"-25/108\", \"0.25\"), got \"" + text + "\"");
}

WrittenFraction fraction(const std::string& text) {
    WrittenFraction read;
    read.negative = text.starts_with('-');
    const std::string size = text.substr(read.negative ? 1 : 0);
    const std::size_t mark = size.find_first_of("./");
    const std::string head = size.substr(0, mark), tail = mark == std::string::npos ? "0" : size.substr(mark + 1);
    if (!is_digits(head) || !is_digits(tail)) refuse(text);
    read.numerator = integer(head);
    if (mark == std::string::npos) return read;
    read.denominator = size[mark] == '/' ? integer(tail) : pow(Integer(10), static_cast<unsigned>(tail.size()));
    if (size[mark] == '.') read.numerator = read.numerator * read.denominator + integer(tail);
    if (read.denominator == 0)
        throw std::invalid_argument("expected a denominator that is not 0, got \"" + text + "\"");
    return read;
}

Rational value(const WrittenFraction& x) {
    const Rational size(x.numerator, x.denominator);
    return x.negative ? Rational(-size) : size;
}

/// So much is exact in double.
bool is_short(const Integer& x) { return x <= Integer(1L << std::numeric_limits<double>::digits); }

Coefficient of_integers(const WrittenFraction& x) {
    const long numerator = x.numerator.convert_to<long>();
    return {x.negative ? -numerator : numerator, x.denominator.convert_to<long>()};
}

}  // namespace

Rational read_exact(const std::string& text) { return value(fraction(text)); }

Coefficient read_coefficient(const std::string& text, std::deque<std::string>& digits) {
    constexpr int decimals = 60;
    const WrittenFraction written = fraction(text);
    const bool decimal = text.find('.') != std::string::npos;
    if (!decimal && written.numerator <= std::numeric_limits<long>::max() &&
        written.denominator <= std::numeric_limits<long>::max())
        return of_integers(written);
    const Rational exact = value(written);
    const WrittenFraction lowest{written.negative, abs(numerator(exact)), denominator(exact)};
    if (is_short(lowest.numerator) && is_short(lowest.denominator)) return of_integers(lowest);
    digits.push_back(decimal ? text : exact.convert_to<Float100>().str(decimals, std::ios_base::fixed));
    return {digits.back().c_str()};
}

bool is_rounded(const std::string& text) {
    const std::size_t point = text.find('.');
    return point != std::string::npos && text.size() - point - 1 >= least_rounded_decimals;
}

}  // namespace kreisel::orders
