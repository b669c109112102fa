// SPDX-License-Identifier: BSD-3-Clause
//
// A data sheet: paragraphs and tables below a title, as text, Markdown and LaTeX.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plots/tables/text.hpp"

namespace kreisel {

struct DataSheet {
    std::string title;
    std::vector<std::string> paragraphs;
    std::vector<TextTable> tables;
    std::vector<std::string> remarks;  ///< below the tables
};

std::string terminal_text(const DataSheet& sheet);
std::string markdown_text(const DataSheet& sheet);
/// A section with tables, for a document that loads booktabs.
std::string latex_text(const DataSheet& sheet);

/// Throws FileError where a file of another origin is at a name that `write_sheet` would write.
void require_own_sheet(const std::filesystem::path& folder, const std::string& name);

/// Writes DIR/name.txt, .md and .tex, where a name "rkmk/rk4" becomes rkmk-rk4. Throws FileError.
void write_sheet(const std::filesystem::path& folder, const std::string& name, const DataSheet& sheet);

}  // namespace kreisel
