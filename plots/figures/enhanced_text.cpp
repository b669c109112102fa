// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/enhanced_text.hpp"

#include <stdexcept>
#include <string_view>

#include "records/json/node.hpp"

namespace kreisel {

std::string gnuplot_quoted(const std::string& text) {
    if (has_control_character(text)) { throw std::invalid_argument("a label of a figure holds a control character"); }
    // gnuplot 5.4 does not read its own escape '' at the start of a string nor in an array, and goes on with the rest
    // as a command. The empty group ends the number of the sign.
    std::string quoted = "'";
    for (const char c : text) { quoted += c == '\'' ? std::string("\\U+0027{}") : std::string(1, c); }
    return quoted + "'";
}

std::string enhanced_escape(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        // gnuplot writes ]]> into an SVG as it is, which is no XML: an empty group parts it.
        if (c == '>' && escaped.ends_with("]]")) { escaped += "{}"; }
        // A backslash is one before U too, where gnuplot would read the number of a sign.
        if (c == 'U' && escaped.ends_with("\\\\")) { escaped += "{}"; }
        if (std::string_view("{}^_@&~\\").find(c) != std::string_view::npos) { escaped += '\\'; }
        escaped += c;
    }
    return escaped;
}

std::size_t enhanced_width(const std::string& text) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (std::string_view("{}^_").find(text[i]) != std::string_view::npos) { continue; }
        if (text[i] == '\\') { ++i; }
        if (i < text.size() && (text[i] & 0xC0) != 0x80) { ++count; }
    }
    return count;
}

}  // namespace kreisel
