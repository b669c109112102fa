// SPDX-License-Identifier: BSD-3-Clause
//
// The mechanisms that an experiment moves.
#pragma once

#include <filesystem>
#include <vector>

#include "driver/plan/plan.hpp"
#include "records/geometry.hpp"

namespace kreisel {

/// Each mechanism with its cells that are not skipped, in the order of the plan; none where no samples are kept.
std::vector<CellGeometry> geometries_of(const Plan& plan, const Engine& engine);

/// Writes DIR/geometry.json where samples are kept. Throws FileError.
void write_geometries(const Plan& plan, const Engine& engine, const std::filesystem::path& folder);

}  // namespace kreisel
