// SPDX-License-Identifier: BSD-3-Clause
//
// Tables from the results of a run.
#pragma once

#include <filesystem>

#include "plots/tables/choice.hpp"
#include "records/reading/read_results.hpp"
#include "records/results.hpp"
#include "support/errors.hpp"

namespace kreisel {

/// `kreisel table DIR`: reads results.jsonl (and trajectories, where there are any) and writes DIR/tables/*.md, *.csv
/// and *.tex: orders, errors, drift, invariants, cost, and the cells that did not run. Prints a summary to standard
/// output, with what is missing of the `planned` cells. Exit::io where something is damaged: the tables then hold the
/// rest. Locks the folder. Throws FileError.
Exit table_command(const std::filesystem::path& folder, const PlannedCells& planned = {});

/// `kreisel table DIR --table NAME ...`: prints that table to standard output and writes nothing. Throws UsageError for
/// what DIR does not have.
Exit chosen_table_command(const std::filesystem::path& folder, const TableChoice& choice,
                          const PlannedCells& planned = {});

}  // namespace kreisel
