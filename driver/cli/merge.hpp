// SPDX-License-Identifier: BSD-3-Clause
//
// The command that puts shards together.
#pragma once

#include <filesystem>
#include <string>

#include "driver/cli/commands.hpp"

namespace kreisel {

/// Merges the journals of several folders or shards; the results go to `output`, by default the first folder. `mixed`:
/// of any builds, not of `build` only. Exit::io where something is damaged, which is left out, or cells are missing,
/// which are listed; Exit::cells_failed where all cells are there and some have failed.
Exit merge_command(const Paths& folders, const std::filesystem::path& output, const std::string& build, bool mixed,
                   const Engines& engines, const Terminal& terminal);

}  // namespace kreisel
