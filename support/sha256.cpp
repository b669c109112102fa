// SPDX-License-Identifier: BSD-3-Clause
#include "support/sha256.hpp"

#include <fmt/format.h>
#include <nettle/sha2.h>

#include <array>

#include "support/files.hpp"

namespace kreisel {

namespace {

using Digest = std::array<std::uint8_t, SHA256_DIGEST_SIZE>;

/// Takes text piece by piece.
class Sha256 {
  public:
    Sha256() { sha256_init(&state_); }
    void add(std::string_view text) {
        const void* bytes = text.data();
        sha256_update(&state_, text.size(), static_cast<const std::uint8_t*>(bytes));
    }
    Digest digest() {
        Digest digest{};
        sha256_digest(&state_, digest.size(), digest.data());
        return digest;
    }

  private:
    sha256_ctx state_{};
};

Digest sha256_of(std::string_view text) {
    Sha256 sum;
    sum.add(text);
    return sum.digest();
}

std::string digits(const Digest& digest) { return fmt::format("{:02x}", fmt::join(digest, "")); }

}  // namespace

std::string sha256_text(std::string_view text) { return digits(sha256_of(text)); }

std::string sha256_of_file(const std::filesystem::path& file) {
    Sha256 sum;
    for_each_piece(file, [&](std::string_view piece) { sum.add(piece); });
    return digits(sum.digest());
}

std::string sha256_bytes(std::string_view text) {
    const auto digest = sha256_of(text);
    return {digest.begin(), digest.end()};
}

}  // namespace kreisel
