// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a machine has room for a run.
#pragma once

#include <filesystem>
#include <string>

#include "driver/campaign/campaign.hpp"
#include "driver/plan/estimate/estimate.hpp"

namespace kreisel {

/// A sentence if the estimate exceeds the memory that is allowed or the disk that is free; else empty. `folder` need
/// not exist. Throws FileError if results are many times as large as what is free, whatever the error of the estimate.
std::string check_room(const Estimate& estimate, const std::filesystem::path& folder, const RunSettings& settings);

}  // namespace kreisel
