// SPDX-License-Identifier: BSD-3-Clause
#include "records/remarks/lost_integrals.hpp"

#include <fmt/format.h>

#include <map>

#include "records/cell/stepping.hpp"

namespace kreisel {

namespace {

struct Group {
    std::size_t ended = 0, lost = 0;
    const ResultRow* worst = nullptr;
};

std::string note_of(const std::string& label, const Group& group) {
    const ResultRow& row = *group.worst;
    return fmt::format(
        "{}: {} of {} cells end ok with more than 1 % of a first integral lost, {} by {:.3g} % at most ({}, {}, "
        "projection {}, {}): their other numbers are no more accurate",
        label, group.lost, group.ended, row.lost_integral, 100 * row.lost_share, row.method, row.formulation,
        row.projection, stepping_text(row));
}

}  // namespace

std::vector<std::string> lost_integral_notes(const std::vector<ResultRow>& rows) {
    std::map<std::string, Group> groups;
    for (const ResultRow& row : rows) {
        if (!row.ok()) { continue; }
        Group& group = groups[row.label];
        ++group.ended;
        if (row.lost_integral.empty()) { continue; }
        ++group.lost;
        if (group.worst == nullptr || row.lost_share > group.worst->lost_share) { group.worst = &row; }
    }
    std::vector<std::string> notes;
    for (const auto& [label, group] : groups) {
        if (group.lost > 0) { notes.push_back(note_of(label, group)); }
    }
    return notes;
}

}  // namespace kreisel
