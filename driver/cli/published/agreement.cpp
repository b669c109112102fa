// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/published/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "records/json/diagnostics.hpp"
#include "support/csv.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

const std::vector<std::string> columns_of_published = {"config", "cells",  "column", "printed",
                                                       "factor", "digits", "source", "remark"};

// Digits after the point; sources print without exponents.
int decimals(const std::string& printed) {
    const std::size_t point = printed.find('.');
    return point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
}

PublishedValue value_of(const std::vector<std::string>& fields) {
    if (fields.size() != columns_of_published.size()) {
        throw std::invalid_argument(
            fmt::format("expected {} fields, got {}", columns_of_published.size(), fields.size()));
    }
    if (fields[3].find_first_not_of("-.0123456789") != std::string::npos) {
        throw std::invalid_argument("expected a decimal number without exponent, got " + in_quotes(fields[3]));
    }
    if (fields[2] == figure_column) { return {fields[0], fields[1], fields[2], "", 1, 0, fields[6], fields[7]}; }
    PublishedValue value{fields[0], fields[1], fields[2], fields[3], std::stold(fields[4]), std::stoi(fields[5]),
                         fields[6], fields[7]};
    if (value.digits < 1 || value.digits > significant_digits(value.printed)) {
        throw std::invalid_argument(
            fmt::format("expected from 1 to {} digits, got {}", significant_digits(value.printed), value.digits));
    }
    return value;
}

}  // namespace

std::vector<PublishedValue> read_published_values(const std::filesystem::path& file) {
    const auto rows = read_csv(read_text(file));
    if (rows.empty() || rows[0] != columns_of_published) {
        throw UsageError(fmt::format("{}: expected the columns {}", file.string(), listed(columns_of_published)));
    }
    std::vector<PublishedValue> values;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        try {
            values.push_back(value_of(rows[i]));
        } catch (const std::logic_error& error) {  // of value_of, stold and stoi
            throw UsageError(fmt::format("{}:{}: {}", file.string(), i + 1, error.what()));
        }
    }
    return values;
}

int significant_digits(const std::string& printed) {
    const std::size_t first = printed.find_first_of("123456789");
    if (first == std::string::npos) { return decimals(printed); }
    return static_cast<int>(std::count_if(printed.begin() + static_cast<std::ptrdiff_t>(first), printed.end(),
                                          [](char c) { return c >= '0' && c <= '9'; }));
}

int agreeing_digits(const std::string& printed, long double value) {
    const long double expected = std::stold(printed), difference = std::abs(value - expected);
    const long double unit = std::pow(10.0L, -static_cast<long double>(decimals(printed)));
    const int all = significant_digits(printed);
    if (difference <= unit * 1.001L) { return all; }
    const long double size = expected == 0 ? 1.0L : std::abs(expected);
    return std::clamp(static_cast<int>(std::floor(std::log10(size / difference))), 0, all - 1);
}

int agreeing_order(const std::string& printed, long double order) {
    const long double declared = std::stold(printed);
    return std::abs(order - declared) <= (declared < 6 ? 0.1L : 0.2L) ? significant_digits(printed) : 0;
}

}  // namespace kreisel
