// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/cite/bibliography.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace kreisel {

namespace build {
extern const char* const bibliography;  // written by cmake/bibliography.cmake
}

namespace {

constexpr auto nowhere = std::string_view::npos;

// Of the brace that closes the first one in `text`; nowhere if there is none.
std::size_t closing_brace(std::string_view text) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
        if (depth == 0 && text[i] == '}') { return i; }
    }
    return nowhere;
}

std::string trimmed(std::string_view text) {
    const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    while (!text.empty() && is_space(text.front())) { text.remove_prefix(1); }
    while (!text.empty() && is_space(text.back())) { text.remove_suffix(1); }
    return std::string(text);
}

// Of the next @ that begins a line.
std::size_t next_entry(std::string_view text, std::size_t from) {
    for (std::size_t at = text.find('@', from); at != nowhere; at = text.find('@', at + 1)) {
        if (at == 0 || text[at - 1] == '\n') { return at; }
    }
    return nowhere;
}

}  // namespace

std::vector<BibliographyEntry> bibliography_entries(std::string_view bibtex) {
    std::vector<BibliographyEntry> entries;
    for (std::size_t at = next_entry(bibtex, 0); at != nowhere; at = next_entry(bibtex, at + 1)) {
        const std::string_view rest = bibtex.substr(at);
        const std::size_t open = rest.find('{'), comma = rest.find(',');
        const std::string key = open < comma ? trimmed(rest.substr(open + 1, comma - open - 1)) : "";
        const std::size_t end = closing_brace(rest);
        if (end == nowhere) { throw std::invalid_argument("the entry \"" + key + "\" of the bibliography has no end"); }
        entries.push_back({key, std::string(rest.substr(0, end + 1))});
    }
    return entries;
}

const std::vector<BibliographyEntry>& bibliography() {
    static const std::vector<BibliographyEntry> entries = bibliography_entries(build::bibliography);
    return entries;
}

std::vector<std::string> keys_cited_in(const BibliographyEntry& entry) {
    static constexpr std::string_view command = "\\cite{";
    std::vector<std::string> keys;
    const std::string_view text = entry.text;
    for (std::size_t at = text.find(command); at != nowhere; at = text.find(command, at + 1)) {
        const std::string_view list = text.substr(at + command.size());
        for (std::size_t from = 0, end = list.find('}'); from < end && end != nowhere;) {
            const std::size_t comma = std::min(list.find(',', from), end);
            keys.push_back(trimmed(list.substr(from, comma - from)));
            from = comma + 1;
        }
    }
    return keys;
}

}  // namespace kreisel
