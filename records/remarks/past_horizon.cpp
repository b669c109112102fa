// SPDX-License-Identifier: BSD-3-Clause
#include "records/remarks/past_horizon.hpp"

#include <fmt/format.h>

#include "records/metrics/catalogue.hpp"
#include "support/number_text.hpp"

namespace kreisel {

namespace {

// Of positions and rotations, if measured: the other quantities are their rates.
std::string uncertainties(const NamedNumbers& errors) {
    std::string text;
    for (const MetricDescription& metric : metric_catalogue()) {
        const auto found = errors.find(metric.name);
        if (metric.level != MetricLevel::configuration || found == errors.end() || found->second == 0) { continue; }
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", rounded_text(found->second, 1), metric.unit);
    }
    return text;
}

std::string note_of(const ResultRow& row, std::size_t cells) {
    const std::string head = fmt::format("{}: {} {} at {} s, past the horizon T* = {:.4g} s of {} reference", row.label,
                                         cells, cells == 1 ? "cell ends" : "cells end", row.t_end,
                                         row.reference_horizon, cells == 1 ? "its" : "their");
    const std::string known = uncertainties(row.reference_error);
    if (known.empty()) { return head + ", whose uncertainty there is not known: no error is measured"; }
    return fmt::format("{}, which is uncertain by {} there: only errors above 100 times its uncertainty are measured",
                       head, known);
}

}  // namespace

void PastHorizon::add(const ResultRow& row) {
    if (!row.ok() || !row.past_horizon) { return; }
    Group& group = groups_[{row.label, row.t_end}];
    if (++group.cells == 1) { group.first = row; }
}

std::vector<std::string> PastHorizon::notes() const {
    std::vector<std::string> notes;
    for (const auto& [key, group] : groups_) { notes.push_back(note_of(group.first, group.cells)); }
    return notes;
}

std::vector<std::string> past_horizon_notes(const std::vector<ResultRow>& rows) {
    PastHorizon past;
    for (const ResultRow& row : rows) { past.add(row); }
    return past.notes();
}

}  // namespace kreisel
