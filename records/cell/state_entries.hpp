// SPDX-License-Identifier: BSD-3-Clause
//
// The numbers of a final state by name, as tables and comparisons list them.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/engine.hpp"

namespace kreisel {

/// "rod.x.1", of the family "x", m. All of one family have the same unit: "x" are the positions of all bodies,
/// "multipliers [N]" all multipliers that are forces.
struct StateEntry {
    std::string name, family, unit;
    Number number;
};

/// The same for a moment: its texts are those of a visit.
struct StateEntryName {
    std::string_view name, family, unit;
};
using VisitStateEntry = std::function<void(const StateEntryName&, const Number&)>;

/// t, x.1 ... omega.3 of each body, R row by row, multipliers ("lambda.pin.2"), reactions ("reaction.pin.force.1"),
/// what keeps prescribed coordinates ("drive.pin.torque"), angles and turns of torsion springs ("theta.1").
void for_each_state_entry(const ReportedState& state, const VisitStateEntry& visit);
std::vector<StateEntry> state_entries(const ReportedState& state);

/// The state that has these entries, by name and unit; which reactions are not unique is not among them. Throws
/// std::invalid_argument for a name that is none of these.
ReportedState state_of(const std::vector<StateEntry>& entries);

}  // namespace kreisel
