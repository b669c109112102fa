// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/certify/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plots/tables/latex.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

struct SheetFiles {
    std::filesystem::path txt, md, tex;
};

SheetFiles files_of_sheet(const std::filesystem::path& folder, const std::string& name) {
    std::string file = name;
    std::replace(file.begin(), file.end(), '/', '-');
    return {folder / (file + ".txt"), folder / (file + ".md"), folder / (file + ".tex")};
}

}  // namespace

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

void require_own_sheet(const std::filesystem::path& folder, const std::string& name) {
    const auto [txt, md, tex] = files_of_sheet(folder, name);
    require_own({txt, md, tex}, md, fmt::format("# {}: ", name));
}

void write_sheet(const std::filesystem::path& folder, const std::string& name, const DataSheet& sheet) {
    const auto [txt, md, tex] = files_of_sheet(folder, name);
    make_folder(folder);
    write_atomically(txt, terminal_text(sheet));
    write_atomically(md, markdown_text(sheet));
    write_atomically(tex, latex_text(sheet));
}

}  // namespace kreisel
