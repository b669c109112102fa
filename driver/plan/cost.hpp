// SPDX-License-Identifier: BSD-3-Clause
//
// What cells and references cost, estimated from the plan only: neither clocks nor machines decide what follows from
// it.
#pragma once

#include "records/cell/planned.hpp"

namespace kreisel {

/// CPU seconds of an identified cell, by order of magnitude; of cells within a config, to a small factor. The numbers
/// of steps to a tolerance and of Newton iterations are guessed.
double cost_of(const PlannedCell& planned, const MethodDescription& method, const SystemSummary& system);

/// The part of such a cost that a cell's own job takes where its CPU time is taken in further rounds, which share the
/// rest alike; else 1.
double first_round_share(const PlannedCell& planned);

/// The same cost of a reference of that system.
double cost_of(const PlannedReference& planned, const SystemSummary& system);

}  // namespace kreisel
