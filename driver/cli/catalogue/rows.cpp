// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/catalogue/rows.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace kreisel {

void print_rows(std::ostream& out, const std::string& title, const std::vector<NamedText>& rows) {
    std::size_t width = 0;
    for (const NamedText& row : rows) { width = std::max(width, row.first.size()); }
    fmt::print(out, "{}\n", title);
    for (const auto& [name, text] : rows) { fmt::print(out, "  {:<{}}  {}\n", name, width, text); }
}

void print_sources(std::ostream& out, const std::vector<std::string>& keys) {
    if (!keys.empty()) { fmt::print(out, "Sources: {}\n", fmt::join(keys, ", ")); }
}

}  // namespace kreisel
