// SPDX-License-Identifier: BSD-3-Clause
//
// Texts for commands that a user can paste.
#pragma once

#include <string>

namespace kreisel {

/// As one word of a POSIX shell.
inline std::string in_shell(const std::string& text) {
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) { return text; }
    std::string quoted = "'";
    for (const char c : text) { quoted += c == '\'' ? "'\\''" : std::string(1, c); }
    return quoted + "'";
}

}  // namespace kreisel
