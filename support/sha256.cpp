// SPDX-License-Identifier: BSD-3-Clause
#include "support/sha256.hpp"

#include <fmt/format.h>
#include <nettle/sha2.h>

#include <array>

namespace kreisel {

namespace {

std::array<std::uint8_t, SHA256_DIGEST_SIZE> sha256_of(std::string_view text) {
    sha256_ctx state;
    sha256_init(&state);
    const void* bytes = text.data();
    sha256_update(&state, text.size(), static_cast<const std::uint8_t*>(bytes));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&state, digest.size(), digest.data());
    return digest;
}

}  // namespace

std::string sha256_text(std::string_view text) { return fmt::format("{:02x}", fmt::join(sha256_of(text), "")); }

std::string sha256_bytes(std::string_view text) {
    const auto digest = sha256_of(text);
    return {digest.begin(), digest.end()};
}

}  // namespace kreisel
