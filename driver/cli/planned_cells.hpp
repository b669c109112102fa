// SPDX-License-Identifier: BSD-3-Clause
//
// What the run of a results folder had planned, for commands that say what is missing.
#pragma once

#include <filesystem>

#include "driver/config/catalogue.hpp"
#include "records/results.hpp"

namespace kreisel {

/// Plans the config of the folder's manifest again. Empty where it has none that this program can plan.
std::vector<CellIdentity> planned_cells(const std::filesystem::path& folder, const Engines& engines);

}  // namespace kreisel
