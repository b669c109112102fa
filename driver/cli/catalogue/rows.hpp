// SPDX-License-Identifier: BSD-3-Clause
//
// Names with a text each, below a title; sources.
#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace kreisel {

using NamedText = std::pair<std::string, std::string>;

/// The names in a column, the texts beside them.
void print_rows(std::ostream& out, const std::string& title, const std::vector<NamedText>& rows);

/// The keys of a bibliography; nothing if there are none.
void print_sources(std::ostream& out, const std::vector<std::string>& keys);

/// Of descriptions with `name` and `summary`.
template <class Description>
std::vector<NamedText> summaries(const std::vector<Description>& all) {
    std::vector<NamedText> rows;
    rows.reserve(all.size());
    for (const auto& one : all) { rows.emplace_back(one.name, one.summary); }
    return rows;
}

}  // namespace kreisel
