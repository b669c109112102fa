// SPDX-License-Identifier: BSD-3-Clause
#include "plots/report/column_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "records/json/lists.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

constexpr std::size_t digits_of_double = 17;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Whether a text is a number as JSON writes it.
bool reads_as_number(const std::string& text) {
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    if (text.size() <= first || !is_digit(text[first]) || text.ends_with('.')) { return false; }
    if (text[first] == '0' && text.size() > first + 1 && is_digit(text[first + 1])) { return false; }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

bool fits_double(const std::string& number) {
    const auto mantissa = number.substr(0, number.find_first_of("eE"));
    return static_cast<std::size_t>(std::count_if(mantissa.begin(), mantissa.end(), is_digit)) <= digits_of_double;
}

std::string number_json(const std::string& text) {
    if (text.empty()) { return "null"; }
    return fits_double(text) ? text : json_text(text);
}

std::string words_json(const std::vector<std::string>& texts) {
    std::map<std::string, std::size_t> known;
    std::vector<std::string> words;
    std::vector<std::size_t> index;
    for (const std::string& text : texts) {
        const auto [found, is_new] = known.insert({text, words.size()});
        if (is_new) { words.push_back(text); }
        index.push_back(found->second);
    }
    return "\"texts\":" + json_value(words) + fmt::format(",\"index\":[{}]", fmt::join(index, ","));
}

std::string contents_json(const ColumnTable::Column& column) {
    const auto is_number = [](const std::string& text) { return text.empty() || reads_as_number(text); };
    const bool numbers = !column.is_text && std::all_of(column.texts.begin(), column.texts.end(), is_number);
    const auto write = [&](const std::string& text) { return numbers ? number_json(text) : json_text(text); };
    const auto& texts = column.texts;
    if (!texts.empty() && std::all_of(texts.begin(), texts.end(), [&](const auto& one) { return one == texts[0]; })) {
        return "\"same\":" + write(texts[0]);
    }
    return numbers ? "\"numbers\":" + json_list(texts, write) : words_json(texts);
}

}  // namespace

ColumnTable by_columns(const TextTable& table) {
    ColumnTable result{table.name, table.title, {}, table.notes};
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        ColumnTable::Column column{table.columns[i], {}};
        for (const auto& row : table.rows) { column.texts.push_back(row[i]); }
        result.columns.push_back(std::move(column));
    }
    return result;
}

std::string json_value(const ColumnTable& table) {
    const auto column = [](const ColumnTable::Column& one) {
        return "{\"title\":" + json_text(one.title) + "," + contents_json(one) + "}";
    };
    const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().texts.size();
    return ObjectWriter()
        .member("name", json_text(table.name))
        .member("title", json_text(table.title))
        .member("notes", json_value(table.notes))
        .member("rows", std::to_string(rows))
        .member("columns", json_list(table.columns, column))
        .text();
}

}  // namespace kreisel
