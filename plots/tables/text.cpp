// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

#include "plots/tables/latex.hpp"
#include "support/csv.hpp"
#include "support/files.hpp"
#include "support/number_text.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

std::string printable(const std::string& text) {
    std::string result = text;
    std::replace_if(result.begin(), result.end(), is_control, '?');
    return result;
}

// What only some readers of Markdown take a backslash before is written as an entity, which all of them know.
std::string markdown_escaped(const std::string& text) {
    static const std::map<char, std::string> entities = {
        {'&', "&amp;"}, {'<', "&lt;"}, {'~', "&#126;"}, {'$', "&#36;"}};
    std::string result;
    for (const char c : printable(text)) {
        if (const auto entity = entities.find(c); entity != entities.end()) {
            result += entity->second;
            continue;
        }
        if (std::string_view("\\`*_{}[]>#|!").find(c) != std::string_view::npos) { result += '\\'; }
        result += c;
    }
    return result;
}

bool is_marked_number(const std::string& text) {
    static const std::regex pattern(R"(([<>]=? )?[-+]?\d+(\.\d+)?(e[-+]?\d+)?\*?)");
    return std::regex_match(text, pattern);
}

bool is_number(const std::string& text) {
    static const std::regex pattern(R"([-+]?\d+(\.\d+)?(e[-+]?\d+)?)");
    return std::regex_match(text, pattern);
}

std::string csv_safe(const std::string& text) {
    const bool formula = !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos;
    const bool harmless = text == "-" || is_number(text);
    return csv_field(formula && !harmless ? "'" + text : text);
}

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
    std::string text;
    for (const std::string& part : parts) { text += (text.empty() ? "" : separator) + part; }
    return text;
}

template <class Escape>
std::vector<std::string> mapped(const std::vector<std::string>& cells, const Escape& escape) {
    std::vector<std::string> result;
    std::transform(cells.begin(), cells.end(), std::back_inserter(result), escape);
    return result;
}

std::string markdown_title(const TextTable& table) { return "# " + markdown_escaped(table.title) + "\n"; }

}  // namespace

std::string short_number(double value) {
    if (std::isnan(value)) { return "-"; }
    return value == 0 ? "0" : rounded_text(value, 2);
}

std::string exact_number(double value) { return std::isnan(value) ? "" : exact_text(value); }

TextTable without_constant_columns(TextTable table, const std::vector<std::string>& candidates) {
    std::vector<std::string> constants, columns;
    std::vector<std::size_t> kept;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const bool candidate = std::find(candidates.begin(), candidates.end(), table.columns[c]) != candidates.end();
        const bool constant =
            !table.rows.empty() && std::all_of(table.rows.begin(), table.rows.end(),
                                               [&](const auto& row) { return row[c] == table.rows.front()[c]; });
        if (candidate && constant) {
            constants.push_back(fmt::format("{}: {}", table.columns[c], table.rows.front()[c]));
        } else {
            columns.push_back(table.columns[c]);
            kept.push_back(c);
        }
    }
    table.columns = std::move(columns);
    for (auto& row : table.rows) {
        std::vector<std::string> cells;
        cells.reserve(kept.size());
        for (const std::size_t c : kept) { cells.push_back(std::move(row[c])); }
        row = std::move(cells);
    }
    if (!constants.empty()) { table.notes.insert(table.notes.begin(), joined(constants, "; ") + "."); }
    return table;
}

std::size_t text_width(const std::string& text) {  // bytes that start a character
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::vector<bool> number_columns(const TextTable& table) {
    std::vector<bool> numbers;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const auto is_there = [&](const auto& row) { return row[c] != "-" && !row[c].empty(); };
        const auto some = std::count_if(table.rows.begin(), table.rows.end(), is_there);
        const auto of_numbers = std::count_if(table.rows.begin(), table.rows.end(),
                                              [&](const auto& row) { return is_marked_number(row[c]); });
        numbers.push_back(2 * of_numbers > some);
    }
    return numbers;
}

std::string terminal_text(const TextTable& table) {
    std::vector<std::size_t> widths;
    for (const std::string& column : table.columns) { widths.push_back(text_width(column)); }
    for (const auto& row : table.rows) {
        for (std::size_t c = 0; c < row.size(); ++c) { widths[c] = std::max(widths[c], text_width(row[c])); }
    }
    const auto line = [&](const std::vector<std::string>& cells) {
        std::string text = " ";
        for (std::size_t c = 0; c < cells.size(); ++c) {
            text += " " + printable(cells[c]) + std::string(widths[c] - text_width(cells[c]) + 1, ' ');
        }
        return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
    };
    std::string text = printable(table.title) + "\n";
    for (const std::string& note : table.notes) { text += "  " + printable(note) + "\n"; }
    text += line(table.columns);
    for (const auto& row : table.rows) { text += line(row); }
    return text;
}

std::string markdown_text(const TextTable& table) {
    const auto line = [](const std::vector<std::string>& cells) {
        return "| " + joined(mapped(cells, markdown_escaped), " | ") + " |\n";
    };
    std::string text = markdown_title(table) + "\n";
    for (const std::string& note : table.notes) { text += markdown_escaped(note) + "\n\n"; }
    text += line(table.columns) + "|";
    for (const bool is_number : number_columns(table)) { text += is_number ? " ---: |" : " --- |"; }
    text += "\n";
    for (const auto& row : table.rows) { text += line(row); }
    return text;
}

std::string csv_text(const TextTable& table) {
    std::string text = joined(mapped(table.columns, csv_safe), ",") + "\n";
    for (const auto& row : table.rows) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) { line += (c == 0 ? "" : ",") + csv_safe(row[c]); }
        text += line + "\n";
    }
    return text;
}

void write_table(const std::filesystem::path& folder, const TextTable& full, const TextTable& brief) {
    const auto csv = folder / (full.name + ".csv"), md = folder / (brief.name + ".md");
    const auto tex = folder / (brief.name + ".tex");
    require_own({csv, md, tex}, md, markdown_title(brief));
    make_folder(folder);
    write_atomically(csv, csv_text(full));
    write_atomically(md, markdown_text(brief));
    write_atomically(tex, latex_text(brief));
}

}  // namespace kreisel
