// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/certify/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plots/tables/latex.hpp"
#include "support/files.hpp"

namespace kreisel {

std::string terminal_text(const DataSheet& sheet) {
    std::string text = sheet.title + "\n";
    for (const std::string& paragraph : sheet.paragraphs) { text += paragraph + "\n"; }
    for (const TextTable& table : sheet.tables) { text += "\n" + terminal_text(table); }
    if (!sheet.remarks.empty()) { text += "\nRemarks\n"; }
    for (const std::string& remark : sheet.remarks) { text += "  " + remark + "\n"; }
    return text;
}

std::string markdown_text(const DataSheet& sheet) {
    std::string text = fmt::format("# {}\n", sheet.title);
    for (const std::string& paragraph : sheet.paragraphs) { text += "\n" + paragraph + "\n"; }
    for (const TextTable& table : sheet.tables) { text += "\n#" + markdown_text(table); }
    if (!sheet.remarks.empty()) { text += "\n## Remarks\n\n"; }
    for (const std::string& remark : sheet.remarks) { text += "- " + remark + "\n"; }
    return text;
}

std::string latex_text(const DataSheet& sheet) {
    std::string text = fmt::format("\\section{{{}}}\n", latex_escaped(sheet.title));
    for (const std::string& paragraph : sheet.paragraphs) { text += "\n" + latex_escaped(paragraph) + "\n"; }
    for (const TextTable& table : sheet.tables) {
        text += fmt::format("\n\\paragraph{{{}}}\\mbox{{}}\\\\\n{}", latex_escaped(table.title), latex_text(table));
    }
    if (sheet.remarks.empty()) { return text; }
    text += "\n\\paragraph{Remarks}\\mbox{}\n\\begin{itemize}\n";
    for (const std::string& remark : sheet.remarks) { text += "  \\item " + latex_escaped(remark) + "\n"; }
    return text + "\\end{itemize}\n";
}

void write_sheet(const std::filesystem::path& folder, const std::string& name, const DataSheet& sheet) {
    std::string file = name;
    std::replace(file.begin(), file.end(), '/', '-');
    std::filesystem::create_directories(folder);
    write_atomically(folder / (file + ".txt"), terminal_text(sheet));
    write_atomically(folder / (file + ".md"), markdown_text(sheet));
    write_atomically(folder / (file + ".tex"), latex_text(sheet));
}

}  // namespace kreisel
