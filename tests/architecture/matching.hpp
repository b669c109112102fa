// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <regex>
#include <string>

namespace architecture {

/// Calls visit(match) for every match of `pattern` in `text`, in order.
template <class Visit>
void each_match(const std::string& text, const std::regex& pattern, Visit visit) {
    for (auto it = std::sregex_iterator(text.begin(), text.end(), pattern); it != std::sregex_iterator(); ++it) {
        visit(*it);
    }
}

/// Where group `i` of a match starts.
inline std::size_t offset(const std::smatch& match, std::size_t i = 0) {
    return static_cast<std::size_t>(match.position(i));
}

}  // namespace architecture
