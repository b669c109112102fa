// SPDX-License-Identifier: BSD-3-Clause
//
// How many printed digits a number agrees with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kreisel {

/// A value as a source prints it, and where the same quantity stands in the results of a shipped config.
struct PublishedValue {
    std::string config;
    std::string column;   ///< of results.csv, or "eigenvalue.3.real", "eigenvalue.3.imaginary" of its linearised motion
    std::string printed;  ///< digit by digit
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

}  // namespace kreisel
