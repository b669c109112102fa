// SPDX-License-Identifier: BSD-3-Clause
#include "support/nearest.hpp"

#include <algorithm>
#include <cctype>

namespace kreisel {

namespace {

constexpr std::size_t longest_word = 64;  // longer words are not typing errors, and the work is bounded

std::string folded(std::string_view word) {
    std::string text(word);
    for (char& c : text) { c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }
    return text;
}

// A scheme without its family ("rk4" for "rkmk/rk4") is a frequent slip that is too far by edit distance.
std::string only_name_ending_in(const std::string& word, const std::vector<std::string>& names) {
    std::string found;
    for (const std::string& name : names) {
        const auto slash = name.rfind('/');
        if (slash == std::string::npos || folded(name.substr(slash + 1)) != word) { continue; }
        if (!found.empty()) { return ""; }
        found = name;
    }
    return found;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
    std::vector<int> before, previous(b.size() + 1), current(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) { previous[j] = static_cast<int>(j); }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int substitution = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, substitution});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                current[j] = std::min(current[j], before[j - 2] + 1);
            }
        }
        before = previous;
        std::swap(previous, current);
    }
    return previous[b.size()];
}

std::string nearest_name(std::string_view word, const std::vector<std::string>& names) {
    if (word.empty() || word.size() > longest_word) { return ""; }
    const std::string typed = folded(word);
    const int allowed = std::max(1, static_cast<int>(typed.size()) / 3);
    int best = allowed + 1;
    bool unique = false;
    std::string found;
    for (const std::string& name : names) {
        const int distance = edit_distance(typed, folded(name));
        if (distance < best) {
            best = distance;
            found = name;
            unique = true;
        } else if (distance == best && name != found) {
            unique = false;
        }
    }
    if (best <= allowed && unique) { return found; }
    return best <= allowed ? "" : only_name_ending_in(typed, names);
}

}  // namespace kreisel
