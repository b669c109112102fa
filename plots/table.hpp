// SPDX-License-Identifier: BSD-3-Clause
//
// Tables from the results of a run.
#pragma once

#include <filesystem>

#include "support/errors.hpp"

namespace kreisel {

/// `kreisel table DIR`: reads results.jsonl (and trajectories, where there are any) and writes DIR/tables/*.md, *.csv
/// and *.tex: orders, errors, drift, invariants, cost, and the cells that did not run. Prints a summary to standard
/// output. Exit::io where result lines are damaged: the tables then hold the others. Throws FileError.
Exit table_command(const std::filesystem::path& folder);

}  // namespace kreisel
