// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/latex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>

namespace kreisel {

namespace {

using Words = std::map<std::string, std::string, std::less<>>;

const Words& special() {
    static const Words words = {{"\\", "\\textbackslash{}"},
                                {"{", "\\{"},
                                {"}", "\\}"},
                                {"$", "\\$"},
                                {"&", "\\&"},
                                {"#", "\\#"},
                                {"%", "\\%"},
                                {"_", "\\_"},
                                {"^", "\\textasciicircum{}"},
                                {"~", "\\textasciitilde{}"},
                                {"<", "\\textless{}"},
                                {">", "\\textgreater{}"},
                                {"|", "\\textbar{}"},
                                {"±", "$\\pm$"}};
    return words;
}

// Signs that LaTeX prints as others than they are, in prose to its advantage.
const Words& of_labels() {
    static const Words words = {{"'", "\\textquotesingle{}"},
                                {"`", "\\textasciigrave{}"},
                                {"\"", "\\texttt{\\char34}"},
                                {"-", "-{}"},
                                {",", ",{}"}};
    return words;
}

const Words& beyond_latin() {
    static const Words words = {
        {"α", "$\\alpha$"},   {"β", "$\\beta$"},  {"γ", "$\\gamma$"},    {"δ", "$\\delta$"},   {"ε", "$\\epsilon$"},
        {"ζ", "$\\zeta$"},    {"η", "$\\eta$"},   {"θ", "$\\theta$"},    {"ι", "$\\iota$"},    {"κ", "$\\kappa$"},
        {"λ", "$\\lambda$"},  {"μ", "$\\mu$"},    {"ν", "$\\nu$"},       {"ξ", "$\\xi$"},      {"ο", "$o$"},
        {"π", "$\\pi$"},      {"ρ", "$\\rho$"},   {"ς", "$\\varsigma$"}, {"σ", "$\\sigma$"},   {"τ", "$\\tau$"},
        {"υ", "$\\upsilon$"}, {"φ", "$\\phi$"},   {"χ", "$\\chi$"},      {"ψ", "$\\psi$"},     {"ω", "$\\omega$"},
        {"Γ", "$\\Gamma$"},   {"Δ", "$\\Delta$"}, {"Θ", "$\\Theta$"},    {"Λ", "$\\Lambda$"},  {"Ξ", "$\\Xi$"},
        {"Π", "$\\Pi$"},      {"Σ", "$\\Sigma$"}, {"Φ", "$\\Phi$"},      {"Ψ", "$\\Psi$"},     {"Ω", "$\\Omega$"},
        {"−", "$-$"},         {"≤", "$\\leq$"},   {"≥", "$\\geq$"},      {"≠", "$\\neq$"},     {"≈", "$\\approx$"},
        {"∞", "$\\infty$"},   {"→", "$\\to$"},    {"√", "$\\surd$"},     {"∂", "$\\partial$"}, {"′", "$'$"},
        {"…", "\\dots{}"},    {"—", "---"},       {"–", "--"},           {"’", "'"},           {"‘", "`"},
        {"“", "``"},          {"”", "''"},        {"€", "\\texteuro{}"}};
    return words;
}

// Whether pdfTeX composes a letter or sign of Latin-1 and Latin Extended-A in its standard encoding.
bool is_composed(char32_t c) {
    static constexpr std::array<char32_t, 27> unknown = {0xAB,  0xBB,  0xD0,  0xDE,  0xF0,  0xFE,  0x104, 0x105, 0x110,
                                                         0x111, 0x118, 0x119, 0x126, 0x127, 0x12E, 0x12F, 0x138, 0x13F,
                                                         0x140, 0x149, 0x14A, 0x14B, 0x166, 0x167, 0x172, 0x173, 0x17F};
    return c > 0xA0 && c < 0x180 && c != 0xAD && std::find(unknown.begin(), unknown.end(), c) == unknown.end();
}

// The bytes of the character that begins there.
std::size_t length_at(const std::string& text, std::size_t at) {
    std::size_t end = at + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) { ++end; }
    return end - at;
}

char32_t code_of(const std::string& character) {
    const auto first = static_cast<unsigned char>(character[0]);
    char32_t code = character.size() == 1 ? first : first & (0x7FU >> character.size());
    for (std::size_t i = 1; i < character.size(); ++i) {
        code = (code << 6U) | (static_cast<unsigned char>(character[i]) & 0x3FU);
    }
    return code;
}

// pdfTeX stops at characters that it has no glyph for: these are named by their number.
std::string character_text(const std::string& character) {
    const char32_t code = code_of(character);
    const bool torn = character.size() == 1 && code > 0x7F;  // no UTF-8
    if (code < 0x20 || code == 0x7F || torn) { return "?"; }
    if (code < 0x7F || is_composed(code)) { return character; }
    const auto known = beyond_latin().find(character);
    return known != beyond_latin().end() ? known->second : fmt::format("[U+{:04X}]", static_cast<unsigned>(code));
}

std::string escaped(const std::string& text, bool label) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const std::string character = text.substr(i, length_at(text, i));
        i += character.size();
        const auto word = special().find(character);
        const auto of_label = label ? of_labels().find(character) : of_labels().end();
        // Two make a dash, or a quotation mark.
        const bool alone = (character == "-" || character == ",") && !text.substr(i).starts_with(character);
        if (word != special().end()) {
            result += word->second;
        } else if (of_label != of_labels().end() && !alone) {
            result += of_label->second;
        } else {
            result += character_text(character);
        }
    }
    return result;
}

std::string latex_cell(const std::string& text) {
    static const std::regex power(R"((-?\d(?:\.\d+)?)e([-+])0*(\d+)(\*?))");  // an asterisk refers to a note
    std::smatch match;
    if (std::regex_match(text, match, power)) {
        const std::string sign = match[2] == "-" ? "-" : "";
        const std::string exponent = match[3].length() == 0 ? "0" : match[3].str();
        return fmt::format("${}\\cdot10^{{{}{}}}${}", match[1].str(), sign, exponent, match[4].str());
    }
    return text == "-" ? "--" : escaped(text, true);
}

// After the end of a line, an asterisk or a bracket would be an argument.
std::string row_text(const std::vector<std::string>& cells) {
    std::string text;
    for (const std::string& cell : cells) { text += (text.empty() ? "" : " & ") + cell; }
    const bool is_argument = !text.empty() && (text.front() == '*' || text.front() == '[');
    return (is_argument ? "{}" : "") + text + " \\\\\n";
}

std::string comment(const std::string& text) {
    std::string line = text;
    std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
    return "% " + line + "\n";
}

// Of the widest cell below the head of a column.
std::size_t cell_width(const TextTable& table, std::size_t column) {
    std::size_t widest = 0;
    for (const auto& row : table.rows) { widest = std::max(widest, text_width(row[column])); }
    return widest;
}

// Characters of the widest row, with what separates columns.
std::size_t width_of(const TextTable& table) {
    constexpr std::size_t separator = 2;
    std::size_t width = 0;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        width += separator + std::max(text_width(table.columns[c]), cell_width(table, c));
    }
    return width;
}

// A head in lines that are broken after dots and at spaces, each no longer than `most` where this can be.
std::string stacked_head(const std::string& head, std::size_t most, bool right) {
    static const std::regex piece(R"([^ .]*[ .]?)");
    std::vector<std::string> lines(1);
    for (auto it = std::sregex_iterator(head.begin(), head.end(), piece); it != std::sregex_iterator(); ++it) {
        if (it->length() == 0) { continue; }
        if (!lines.back().empty() && text_width(lines.back() + it->str()) > most) { lines.emplace_back(); }
        lines.back() += it->str();
    }
    std::string text;
    for (const std::string& line : lines) {
        const bool is_argument = line.starts_with('*') || line.starts_with('[');
        text += (text.empty() ? "" : "\\\\") + std::string(is_argument ? "{}" : "") + latex_escaped(line);
    }
    return lines.size() == 1 ? text : fmt::format("\\shortstack[{}]{{{}}}", right ? 'r' : 'l', text);
}

std::vector<std::string> heads_of(const TextTable& table, const std::vector<bool>& numbers, bool wide) {
    constexpr std::size_t least = 6;  // characters of a line
    std::vector<std::string> heads;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const std::string& head = table.columns[c];
        heads.push_back(wide ? stacked_head(head, std::max(cell_width(table, c), least), numbers[c])
                             : latex_escaped(head));
    }
    return heads;
}

// In the largest of three sizes in which it is no wider than a line. What is wider in all of them is scaled, if it is
// little, or turned, and then no longer than most of a page, where the document has graphicx.
std::string fitted_text(const std::string& tabular) {
    std::string text = "\\begingroup\n\\def\\kreiseltable{" + tabular + "}%\n\\sbox0{\\kreiseltable}%\n";
    for (const auto& [size, separation] : {std::pair("footnotesize", "4pt"), std::pair("scriptsize", "2.5pt")}) {
        text +=
            fmt::format("\\ifdim\\wd0>\\linewidth\\{}\\setlength{{\\tabcolsep}}{{{}}}\\sbox0{{\\kreiseltable}}\\fi\n",
                        size, separation);
    }
    text +=
        "\\ifdim\\wd0>\\linewidth\\ifdefined\\rotatebox\n"
        "\\ifdim\\wd0<1.1\\linewidth\\sbox0{\\resizebox{\\linewidth}{!}{\\usebox0}}\\else\n"
        "\\sbox0{\\rotatebox{90}{\\usebox0}}%\n"
        "\\ifdim\\ht0>.9\\textheight\\sbox0{\\resizebox{!}{.9\\textheight}{\\usebox0}}\\fi\n"
        "\\fi\\fi\\fi\n";
    return text + "\\usebox0%\n\\endgroup\n";
}

// Whether some number of a column refers to a note: the others leave the space of an asterisk.
std::vector<bool> marked_columns(const TextTable& table, const std::vector<bool>& numbers) {
    std::vector<bool> marked;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        marked.push_back(numbers[c] && std::any_of(table.rows.begin(), table.rows.end(),
                                                   [&](const auto& row) { return row[c].ends_with('*'); }));
    }
    return marked;
}

std::string row_of(const std::vector<std::string>& texts, const std::vector<bool>& marked) {
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < texts.size(); ++c) {
        cells.push_back(latex_cell(texts[c]) + (marked[c] && !texts[c].ends_with('*') ? "\\phantom{*}" : ""));
    }
    return row_text(cells);
}

}  // namespace

std::string latex_escaped(const std::string& text) { return escaped(text, false); }

std::string latex_text(const TextTable& table) {
    std::string text = comment(table.title);
    for (const std::string& note : table.notes) { text += comment(note); }
    constexpr std::size_t line = 60;  // characters that fit on any page
    const bool wide = width_of(table) > line;
    const std::vector<bool> numbers = number_columns(table);
    std::string alignment;
    for (const bool is_number : numbers) { alignment += is_number ? 'r' : 'l'; }
    std::string tabular = fmt::format("\\begin{{tabular}}{{{}}}\n\\toprule\n", alignment);
    tabular += row_text(heads_of(table, numbers, wide)) + "\\midrule\n";
    const std::vector<bool> marked = marked_columns(table, numbers);
    for (const auto& row : table.rows) { tabular += row_of(row, marked); }
    tabular += "\\bottomrule\n\\end{tabular}";
    return text + (wide ? fitted_text(tabular) : tabular + "\n");
}

}  // namespace kreisel
