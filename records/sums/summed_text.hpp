// SPDX-License-Identifier: BSD-3-Clause
//
// JSON objects whose last member is a check sum of the text before it: lines of journals and results, references,
// manifests. hash_text changes with every single byte, whatever the others are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kreisel {

/// How the last member is written.
struct SumStyle {
    std::string_view before, after;  ///< around the 16 digits
};
inline constexpr SumStyle compact_sum{R"(,"sum":")", "\"}"};
inline constexpr SumStyle indented_sum{",\n  \"sum\": \"", "\"\n}\n"};

enum class SumState { absent, holds, wrong };

/// `open`, an object without its closing brace, with its sum and the brace.
std::string with_sum(std::string_view open, const SumStyle& style = compact_sum);

SumState sum_state(std::string_view object, const SumStyle& style = compact_sum);

/// What the sum is of: the object up to it. The object must have one.
std::string_view before_sum(std::string_view object, const SumStyle& style = compact_sum);

/// Whether lines of a folder must have sums: those of this format do, and where the format is not known one sum tells
/// of all.
bool lines_have_sums(const std::vector<std::string>& lines, bool known);
/// Throws std::invalid_argument if the sum of a line does not hold, or `expected` is absent.
void require_sum(const std::string& line, bool expected);

}  // namespace kreisel
