// SPDX-License-Identifier: BSD-3-Clause
#include "support/csv.hpp"

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
    if (text.find_first_of(",\"\n\r") == std::string::npos) { return text; }
    std::string quoted = "\"";
    for (const char c : text) { quoted += c == '"' ? std::string("\"\"") : std::string(1, c); }
    return quoted + "\"";
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
