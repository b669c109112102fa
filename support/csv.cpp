// SPDX-License-Identifier: BSD-3-Clause
#include "support/csv.hpp"

#include <algorithm>
#include <stdexcept>

namespace kreisel {

namespace {

/// Reads the quoted field that begins at `at`, and moves behind its last quote.
std::string quoted_field(const std::string& text, std::size_t& at) {
    std::string field;
    for (++at; at < text.size(); ++at) {
        if (text[at] != '"') {
            field += text[at];
        } else if (at + 1 < text.size() && text[at + 1] == '"') {
            field += text[++at];
        } else {
            return ++at, field;
        }
    }
    throw std::invalid_argument("a quoted field does not end");
}

}  // namespace

std::string csv_field(const std::string& text) {
    std::string field;
    append_csv_field(field, text);
    return field;
}

void append_csv_field(std::string& row, std::string_view text) {
    // Digits and letters come behind the comma.
    const auto needs_quotes = [](char c) { return c <= ',' && (c == ',' || c == '"' || c == '\n' || c == '\r'); };
    if (std::none_of(text.begin(), text.end(), needs_quotes)) {
        row += text;
        return;
    }
    row += '"';
    for (const char c : text) { row.append(c == '"' ? 2 : 1, c); }
    row += '"';
}

std::vector<std::vector<std::string>> read_csv(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    bool new_row = true;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (new_row) { rows.emplace_back(); }
        std::string& field = rows.back().emplace_back();
        if (text[at] == '"') { field = quoted_field(text, at); }
        while (at < text.size() && text[at] != ',' && text[at] != '\n') { field += text[at++]; }
        new_row = at >= text.size() || text[at] == '\n';
        if (at + 1 == text.size() && text[at] == ',') { rows.back().emplace_back(); }
    }
    return rows;
}

}  // namespace kreisel
