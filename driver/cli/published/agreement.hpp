// SPDX-License-Identifier: BSD-3-Clause
//
// How many printed digits a number agrees with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kreisel {

/// Stands for a quantity where a source prints a figure and no digits: the config draws one of the same shape.
inline constexpr const char* figure_column = "figure";

/// A value as a source prints it, and where the same quantity stands in the results of a shipped config.
struct PublishedValue {
    std::string config;
    std::string cells;       ///< which count, "steps=2000 formulation=SE3", by titles of results.csv; empty: all
    std::string column;      ///< a quantity that PublishedRuns::find knows, or figure_column
    std::string printed;     ///< digit by digit; empty for a figure
    long double factor = 1;  ///< the unit of what is printed, in that of the column
    int digits = 0;          ///< that agree at least; fewer are an error
    std::string source, remark;
};

/// Reads experiments/published/published.csv. Throws FileError if it cannot be read, UsageError with file and line
/// where a line is damaged.
std::vector<PublishedValue> read_published_values(const std::filesystem::path& file);

/// Significant digits of a decimal number; of zero, those after the point.
int significant_digits(const std::string& printed);

/// How many of them a value agrees with: all if it differs by at most one unit of the last digit (a source may round
/// either way), else the number of leading digits, floor(log10(|printed|/|difference|)).
int agreeing_digits(const std::string& printed, long double value);

/// The same of an order, a whole number: all where the observed one is within 0.1 (from 6 on 0.2), else none.
int agreeing_order(const std::string& printed, long double order);

}  // namespace kreisel
