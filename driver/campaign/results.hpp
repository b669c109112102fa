// SPDX-License-Identifier: BSD-3-Clause
//
// What a run leaves beside its journal: results.jsonl, results.csv, and what manifest and terminal say of its cells.
#pragma once

#include <filesystem>
#include <string>

#include "driver/campaign/campaign.hpp"
#include "driver/campaign/finished.hpp"
#include "records/cell/table.hpp"
#include "records/manifest.hpp"

namespace kreisel {

/// results.jsonl and results.csv of the finished cells, in the order of the plan. They are read one by one.
void write_results(const Plan& plan, const FinishedCells& finished, const TableUnits& units,
                   const std::filesystem::path& folder);

/// Units of the columns of results.csv.
TableUnits table_units(const Plan& plan, const Engine& engine);

/// Over the cells of the settings' shard.
CellCounts count_cells(const Plan& plan, const FinishedCells& finished, const RunSettings& settings);

/// What the manifest says of a plan.
ManifestSubject manifest_subject(const Plan& plan);

/// What a cell runs, on one line.
std::string cell_text(const PlannedCell& planned);

/// A failed cell, described on one line.
std::string failure_text(const PlannedCell& planned, const CellOutcome& outcome);

}  // namespace kreisel
