// SPDX-License-Identifier: BSD-3-Clause
#include "plots/tables/choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "plots/tables/latex.hpp"
#include "support/errors.hpp"
#include "support/nearest.hpp"
#include "support/pattern.hpp"

namespace kreisel {

namespace {

constexpr std::size_t longest_number = 7;  // that is shown as it is: an order of 4.0000, a year of steps

using Names = std::vector<std::string>;

[[noreturn]] void refuse(const std::string& option, const std::string& expected, const std::string& got,
                         const Names& valid) {
    const std::string near = nearest_name(got, valid);
    throw UsageError(fmt::format("{}: expected {} ({}), got \"{}\"{}", option, expected, fmt::join(valid, ", "), got,
                                 near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near)));
}

std::string without_unit(const std::string& title) { return title.substr(0, title.find(" [")); }

TextTable table_named(const Results& results, const std::string& name) {
    Names names;
    for (const ResultTable& table : result_tables()) {
        if (!table.applies(results)) { continue; }
        for (TablePair& pair : table.make(results)) {
            if (pair.full.rows.empty()) { continue; }
            if (pair.full.name == name) { return std::move(pair.full); }
            names.push_back(pair.full.name);
        }
    }
    refuse("--table", "a table of these results", name, names);
}

std::size_t column_named(const TextTable& table, const std::string& option, const std::string& name) {
    const auto is_meant = [&](const std::string& title) { return title == name || without_unit(title) == name; };
    const auto found = std::find_if(table.columns.begin(), table.columns.end(), is_meant);
    if (found == table.columns.end()) {
        refuse(option, fmt::format("a column of the table {}", table.name), name, table.columns);
    }
    return static_cast<std::size_t>(found - table.columns.begin());
}

/// "a=b" in two; the sign is the first or the last one.
std::pair<std::string, std::string> parted(const std::string& option, const std::string& text, std::size_t sign,
                                           const std::string& form) {
    if (sign == std::string::npos || sign == 0) {
        throw UsageError(fmt::format("{}: expected {}, got \"{}\"", option, form, text));
    }
    return {text.substr(0, sign), text.substr(sign + 1)};
}

void choose_rows(TextTable& table, const Names& conditions) {
    std::map<std::size_t, Names> patterns;
    for (const std::string& condition : conditions) {
        const auto [title, pattern] = parted("--rows", condition, condition.find('='), "COLUMN=PATTERN");
        patterns[column_named(table, "--rows", title)].push_back(pattern);
    }
    std::erase_if(table.rows, [&](const Names& row) {
        return std::any_of(patterns.begin(), patterns.end(),
                           [&](const auto& pattern) { return !matches_any(pattern.second, row[pattern.first]); });
    });
    if (table.rows.empty()) {
        throw UsageError(
            fmt::format("--rows: no row of the table {} has {}", table.name, fmt::join(conditions, " and ")));
    }
}

void choose_columns(TextTable& table, const Names& titles) {
    if (titles.empty()) { return; }
    std::vector<std::size_t> chosen;
    for (const std::string& title : titles) { chosen.push_back(column_named(table, "--columns", title)); }
    const auto choose = [&](Names& all) {
        Names kept;
        for (const std::size_t column : chosen) { kept.push_back(all[column]); }
        all = std::move(kept);
    };
    choose(table.columns);
    std::for_each(table.rows.begin(), table.rows.end(), choose);
}

std::string rounded(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = error == std::errc() && end == text.data() + text.size();
    return is_number && text.size() > longest_number ? short_number(value) : text;
}

void round_numbers(TextTable& table) {
    for (Names& row : table.rows) { std::transform(row.begin(), row.end(), row.begin(), rounded); }
}

void rename(TextTable& table, const Names& names) {
    std::map<std::string, std::string> printed;
    for (const std::string& name : names) { printed.insert(parted("--names", name, name.rfind('='), "TEXT=NAME")); }
    const auto rename_all = [&](Names& texts) {
        for (std::string& text : texts) {
            if (const auto name = printed.find(text); name != printed.end()) { text = name->second; }
        }
    };
    rename_all(table.columns);
    std::for_each(table.rows.begin(), table.rows.end(), rename_all);
}

}  // namespace

const std::vector<std::string>& table_formats() {
    static const std::vector<std::string> all = {"text", "markdown", "latex", "csv"};
    return all;
}

std::string chosen_table(const Results& results, const TableChoice& choice) {
    TextTable table = table_named(results, choice.table);
    choose_rows(table, choice.rows);
    choose_columns(table, choice.columns);
    if (choice.format != "csv") { round_numbers(table); }
    rename(table, choice.names);
    if (choice.format == "csv") { return csv_text(table); }
    if (choice.format == "latex") { return latex_text(table); }
    return choice.format == "markdown" ? markdown_text(table) : terminal_text(table);
}

}  // namespace kreisel
