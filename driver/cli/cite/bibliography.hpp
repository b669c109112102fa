// SPDX-License-Identifier: BSD-3-Clause
//
// The bibliography of the paper, paper/references.bib, which the build puts into the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kreisel {

struct BibliographyEntry {
    std::string key;
    std::string text;  ///< from its @ to its closing brace
};

/// The entries of a BibTeX text, in its order; what lies between them is comment. Throws std::invalid_argument, with
/// the key, where an entry does not end.
std::vector<BibliographyEntry> bibliography_entries(std::string_view bibtex);

/// Those of the project.
const std::vector<BibliographyEntry>& bibliography();

/// The keys that an entry cites itself, by \cite{key}.
std::vector<std::string> keys_cited_in(const BibliographyEntry& entry);

}  // namespace kreisel
