// SPDX-License-Identifier: BSD-3-Clause
//
// The numbers of a final state by name, as tables and comparisons list them.
#pragma once

#include <string>
#include <vector>

#include "engine/engine.hpp"

namespace kreisel {

/// "rod.x.1", of the family "x", m. All of one family have the same unit: "x" are the positions of all bodies,
/// "multipliers [N]" all multipliers that are forces.
struct StateEntry {
    std::string name, family, unit;
    Number number;
};

/// All of a state, in the order of name_state.
std::vector<StateEntry> state_entries(const ReportedState& state);

/// The state that has these entries, by name and unit; which reactions are not unique is not among them. Throws
/// std::invalid_argument for a name that is none of these.
ReportedState state_of(const std::vector<StateEntry>& entries);

}  // namespace kreisel
