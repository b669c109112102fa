// SPDX-License-Identifier: BSD-3-Clause
#include "support/base64.hpp"

#include <nettle/base64.h>

namespace kreisel {

std::string base64_text(std::string_view bytes) {
    std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
    const void* first = bytes.data();
    base64_encode_raw(text.data(), bytes.size(), static_cast<const std::uint8_t*>(first));
    return text;
}

}  // namespace kreisel
