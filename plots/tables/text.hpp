// SPDX-License-Identifier: BSD-3-Clause
//
// A table as text: aligned for a terminal, Markdown and CSV; LaTeX is in plots/tables/latex.hpp. Every cell is data:
// each writer escapes characters that its format would read as syntax.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace kreisel {

struct TextTable {
    std::string name;   ///< file name without extension
    std::string title;  ///< one line
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> notes = {};  ///< how to read it; a paragraph each
};

/// "1.15e-03"; "0" for zero; "-" for a number that is absent (NaN).
std::string short_number(double value);
/// Shortest text that reads back exactly; empty where absent (NaN).
std::string exact_number(double value);

/// Moves the columns that hold one value all over into a note "problem: heavy_top; precision: double".
TextTable without_constant_columns(TextTable table, const std::vector<std::string>& candidates);

/// Of each column whether most of its cells hold a number, which may be marked, as "<= 1.15e-03*": such columns are
/// aligned at the right.
std::vector<bool> number_columns(const TextTable& table);
/// Characters of UTF-8: what a terminal counts.
std::size_t text_width(const std::string& text);

std::string terminal_text(const TextTable& table);
std::string markdown_text(const TextTable& table);
/// RFC 4180. Text that a spreadsheet would read as a formula is preceded by an apostrophe; notes are left out.
std::string csv_text(const TextTable& table);

/// Writes folder/<name>.md, .csv and .tex. `full` goes to the CSV, `brief` to the others. Throws FileError,
/// also where one of them is there and the Markdown there has not this title: then it is someone else's.
void write_table(const std::filesystem::path& folder, const TextTable& full, const TextTable& brief);

}  // namespace kreisel
