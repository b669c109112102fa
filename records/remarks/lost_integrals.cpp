// SPDX-License-Identifier: BSD-3-Clause
#include "records/remarks/lost_integrals.hpp"

#include <fmt/format.h>

#include "records/cell/stepping.hpp"

namespace kreisel {

namespace {

std::string loss_of(const ResultRow& row) {
    return fmt::format("{} by {:.3g} % at most ({}, {}, projection {}, {})", row.lost_integral, 100 * row.lost_share,
                       row.method, row.formulation, row.projection, stepping_text(row));
}

}  // namespace

void LostIntegrals::add(const ResultRow& row) {
    if (!row.ok()) { return; }
    Group& group = groups_[row.label];
    ++group.ended;
    if (row.lost_integral.empty()) { return; }
    if (++group.lost > 1 && row.lost_share <= group.share) { return; }
    group.share = row.lost_share;
    group.worst = loss_of(row);
}

std::vector<std::string> LostIntegrals::notes() const {
    std::vector<std::string> notes;
    for (const auto& [label, group] : groups_) {
        if (group.lost == 0) { continue; }
        notes.push_back(fmt::format(
            "{}: {} of {} cells end ok with more than 1 % of a first integral lost, {}: their other numbers "
            "are no more accurate",
            label, group.lost, group.ended, group.worst));
    }
    return notes;
}

std::vector<std::string> lost_integral_notes(const std::vector<ResultRow>& rows) {
    LostIntegrals lost;
    for (const ResultRow& row : rows) { lost.add(row); }
    return lost.notes();
}

}  // namespace kreisel
