// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/past_horizon.hpp"

#include <fmt/format.h>

#include <map>

namespace kreisel {

namespace {

std::string note_of(const ResultRow& row, std::size_t cells) {
    const std::string head = fmt::format("{}: {} {} at {} s, past the horizon T* = {:.4g} s of {} reference", row.label,
                                         cells, cells == 1 ? "cell ends" : "cells end", row.t_end,
                                         row.reference_horizon, cells == 1 ? "its" : "their");
    const auto uncertainty = row.reference_error.find("error.position");
    if (uncertainty == row.reference_error.end()) {
        return head + ", whose uncertainty there is not known: no error is measured";
    }
    return head +
           fmt::format(
               ", which is uncertain by {:.1e} m there: only errors above 100 times its uncertainty are measured",
               uncertainty->second);
}

}  // namespace

std::vector<std::string> past_horizon_notes(const std::vector<ResultRow>& rows) {
    std::map<std::pair<std::string, double>, std::pair<const ResultRow*, std::size_t>> groups;
    for (const ResultRow& row : rows) {
        if (!row.ok() || !row.past_horizon) { continue; }
        auto& [first, cells] = groups[{row.label, row.t_end}];
        first = first == nullptr ? &row : first;
        ++cells;
    }
    std::vector<std::string> notes;
    for (const auto& [key, group] : groups) { notes.push_back(note_of(*group.first, group.second)); }
    return notes;
}

}  // namespace kreisel
