// SPDX-License-Identifier: BSD-3-Clause
//
// Patterns over names, for the driver and the numerical code alike.
#pragma once

#include <string_view>

namespace kreisel {

/// True if `name` fits `pattern`, in which `*` matches any characters, or none. Whatever the pattern, it takes at
/// most (length of pattern + 1) (length of name + 1) comparisons: names are short, so that it is linear in the pattern.
inline bool matches(std::string_view pattern, std::string_view name) {
    // What follows the last star is tried at one place of the name after another. An earlier star need not be tried
    // again: the leftmost match of what follows it leaves most of the name to the later ones.
    std::size_t p = 0, n = 0, star = std::string_view::npos, resume = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = n;
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++resume;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

/// True if `name` fits one of the patterns.
template <class Patterns>
bool matches_any(const Patterns& patterns, std::string_view name) {
    for (const std::string_view pattern : patterns) {
        if (matches(pattern, name)) { return true; }
    }
    return false;
}

}  // namespace kreisel
