// SPDX-License-Identifier: BSD-3-Clause
//
// Base64 (RFC 4648), for bytes within text.
#pragma once

#include <string>
#include <string_view>

namespace kreisel {

std::string base64_text(std::string_view bytes);

}  // namespace kreisel
