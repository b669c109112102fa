// SPDX-License-Identifier: BSD-3-Clause
//
// Results read from their folder.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// The cells that were planned, in their order; called where some are missing. Empty: they are not known.
using PlannedCells = std::function<std::vector<CellIdentity>()>;

/// Throws FileError if the folder has no results.jsonl.
void require_results(const std::filesystem::path& folder);

/// Reads DIR/results.jsonl and DIR/manifest.json, and for kinds that measure times those in DIR/journal*.jsonl. All
/// sums are checked; a damaged line, manifest or trajectory is left out and named in `damage`. Throws FileError where
/// results.jsonl cannot be read.
Results read_results(const std::filesystem::path& folder, const PlannedCells& planned = {});

}  // namespace kreisel
