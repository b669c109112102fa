// SPDX-License-Identifier: BSD-3-Clause
//
// Rules that keep numerical code right in every precision, where no compiler warning does.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include "tests/architecture/matching.hpp"
#include "tests/architecture/rules.hpp"

namespace architecture {

namespace {

bool is_numerical(const Source& source) {
    static const std::array<std::string_view, 6> folders = {"lie",     "mechanics", "problems",
                                                            "methods", "peers",     "engine"};
    return source.is_cpp() && std::find(folders.begin(), folders.end(), source.folder()) != folders.end();
}

/// Plain data of the boundary between driver and numerics: double by design, read as decimals on the other side.
bool is_data_header(const Source& source) {
    return source.path == "mechanics/model/data.hpp" || source.path.ends_with("/description.hpp");
}

/// The text between the last semicolon and `end`: the statement so far.
std::string statement_before(const std::string& code, std::size_t end) {
    const auto semicolon = code.rfind(';', end);
    const auto start = semicolon == std::string::npos ? 0 : semicolon + 1;
    return code.substr(start, end - start);
}

/// A literal may be any decimal if its type makes it a double, which `decimal` later reads exactly.
bool becomes_decimal_data(const std::string& code, std::size_t at) {
    static const std::regex data(
        R"(\b(decimal|moments|Vector3|Matrix3|BodyData|JointData|ForceData|ParameterDescription|)"
        R"(ParameterValues?|KREISEL_PROBLEM|double)\b)");
    return std::regex_search(statement_before(code, at), data);
}

/// Divides m by 5 at most `count` times while it is divisible; returns the rest of count.
int cancel_fives(long long& m, int count) {
    for (; count > 0 && m % 5 == 0; --count) { m /= 5; }
    return count;
}

}  // namespace

bool is_dyadic(const std::string& literal) {
    constexpr long long largest = 1LL << 53;
    long long mantissa = 0;
    int exponent = 0;
    std::size_t at = 0;
    for (bool fraction = false; at < literal.size() && std::tolower(literal[at]) != 'e'; ++at) {
        if (literal[at] == '.') { fraction = true; }
        if (std::isdigit(static_cast<unsigned char>(literal[at])) == 0) { continue; }
        if (mantissa > largest) { return false; }
        mantissa = 10 * mantissa + (literal[at] - '0');
        if (fraction) { --exponent; }
    }
    if (at < literal.size()) { exponent += std::stoi(literal.substr(at + 1)); }
    if (mantissa == 0) { return true; }
    // 10^e = 2^e 5^e: for e < 0 the fives must cancel; for e > 0 they must fit into the 53 bits.
    if (exponent < 0) { return cancel_fives(mantissa, -exponent) == 0; }
    return static_cast<double>(mantissa) * std::pow(5.0, exponent) < static_cast<double>(largest);
}

std::vector<Finding> check_literals(const std::vector<Source>& tree) {
    static const std::regex literal(
        R"((^|[^\w.'])((\d[\d']*\.[\d']*|\.\d[\d']*)([eE][+-]?\d+)?|\d[\d']*[eE][+-]?\d+)([fFlLqQ]?))");
    std::vector<Finding> findings;
    for (const auto& source : tree) {
        if (!is_numerical(source) || is_data_header(source)) { continue; }
        each_match(source.code, literal, [&](const std::smatch& m) {
            const auto at = offset(m, 2);
            if (m[5].length() == 0 && (is_dyadic(m[2]) || becomes_decimal_data(source.code, at))) { return; }
            findings.push_back({source.path, source.line_of(at), "literal",
                                m[2].str() + m[5].str() + " is not the same number in every precision"});
        });
    }
    return findings;
}

std::vector<Finding> check_math_calls(const std::vector<Source>& tree) {
    static const std::regex call(
        R"(\bstd\s*::\s*(abs|fabs|sqrt|cbrt|hypot|pow|exp|log|log2|sin|cos|tan|asin|acos|atan|atan2|isfinite|)"
        R"(isnan|floor|ceil)\s*\()");
    std::vector<Finding> findings;
    for (const auto& source : tree) {
        if (!is_numerical(source) || source.path == "lie/real.hpp") { continue; }
        each_match(source.code, call, [&](const std::smatch& m) {
            findings.push_back({source.path, source.line_of(offset(m)), "qualified",
                                "std::" + m[1].str() + " rounds quad to double: call it unqualified"});
        });
    }
    return findings;
}

std::vector<Finding> check_precision_namespace(const std::vector<Source>& tree) {
    static const std::regex real(R"(\bReal\b)");
    std::vector<Finding> findings;
    for (const auto& source : tree) {
        if (!is_numerical(source)) { continue; }
        std::smatch match;
        if (!std::regex_search(source.code, match, real)) { continue; }
        if (source.code.find("inline namespace KREISEL_PRECISION") != std::string::npos) { continue; }
        findings.push_back({source.path, source.line_of(offset(match)), "precision",
                            "mentions Real outside inline namespace KREISEL_PRECISION"});
    }
    return findings;
}

}  // namespace architecture
