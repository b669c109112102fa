// SPDX-License-Identifier: BSD-3-Clause
//
// Text and tables in LaTeX, for pdfTeX without further packages than booktabs.
#pragma once

#include <string>

#include "plots/tables/text.hpp"

namespace kreisel {

/// A `tabular` with the rules of booktabs, numbers as 1.15 * 10^-3 in mathematics, columns of numbers aligned at the
/// right; notes as comments. What may be wider than a line of text is set in the size in which it fits, its heads in
/// several lines; what fits in none is scaled or turned by 90 degrees where the document has graphicx.
std::string latex_text(const TextTable& table);

/// Text in LaTeX: every special character escaped, characters that pdfTeX lacks by their number ([U+4E2D]), control
/// characters replaced by a question mark. In cells of tables quotes and hyphens are shown as they are, too.
std::string latex_escaped(const std::string& text);

}  // namespace kreisel
