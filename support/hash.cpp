// SPDX-License-Identifier: BSD-3-Clause
#include "support/hash.hpp"

namespace kreisel {

std::uint64_t hash64(std::string_view text, std::uint64_t start) {
    std::uint64_t hash = start;
    for (const char c : text) { hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U; }
    return hash;
}

std::string hash_text(std::uint64_t hash) {
    std::string text(16, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, hash >>= 4U) {
        *digit = "0123456789abcdef"[hash & 0xfU];
    }
    return text;
}

std::string hash_text(std::string_view text) { return hash_text(hash64(text)); }

}  // namespace kreisel
