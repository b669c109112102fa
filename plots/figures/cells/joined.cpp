// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/cells/joined.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace kreisel {

namespace {

void name_rows(std::vector<ResultRow>& rows, const std::string& experiment, bool is_only_one) {
    for (ResultRow& row : rows) {
        row.results = is_only_one ? experiment : fmt::format("{} ({})", experiment, row.folder->string());
    }
}

template <class T>
void append(std::vector<T>& to, std::vector<T>& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace

Results joined(std::vector<Results> all) {
    if (all.size() == 1) { return std::move(all.front()); }
    for (Results& one : all) {
        const auto same =
            std::count_if(all.begin(), all.end(), [&](const Results& other) { return other.name == one.name; });
        name_rows(one.rows, one.name, same == 1);
        name_rows(one.missing, one.name, same == 1);
    }
    Results results = std::move(all.front());
    for (auto one = std::next(all.begin()); one != all.end(); ++one) {
        append(results.rows, one->rows);
        append(results.missing, one->missing);
        append(results.damage, one->damage);
        results.units.insert(one->units.begin(), one->units.end());
    }
    return results;
}

}  // namespace kreisel
