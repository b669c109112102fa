// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the line and column of a JSON value in its source text, so that messages can point at it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kreisel {

/// Counted from 1; columns count characters, not bytes.
struct Position {
    long line = 1, column = 1;
};

/// What to point at: a value, or the key that names it.
enum class Target { value, key };

Position position_of_byte(std::string_view text, std::size_t byte);

/// Byte offset of the value `pointer` (RFC 6901) names in `text`, or of its nearest existing ancestor. If an object
/// holds the last key several times, `occurrence` selects one. Never fails, even on text that is not JSON.
std::size_t locate(std::string_view text, const std::string& pointer, Target target = Target::value,
                   int occurrence = 1);

/// `pointer` with one more reference token, escaped.
std::string pointer_below(const std::string& pointer, std::string_view token);

}  // namespace kreisel
