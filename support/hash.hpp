// SPDX-License-Identifier: BSD-3-Clause
//
// A stable 64-bit hash of text: names of cells, check sums of lines. Not for security.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kreisel {

/// FNV-1a, 64 bit. Can be continued: hash64(b, hash64(a)) == hash64(a + b).
std::uint64_t hash64(std::string_view text, std::uint64_t start = 0xcbf29ce484222325U);

/// hash64 as 16 hexadecimal digits.
std::string hash_text(std::string_view text);
std::string hash_text(std::uint64_t hash);

}  // namespace kreisel
