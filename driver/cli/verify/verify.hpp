// SPDX-License-Identifier: BSD-3-Clause
//
// The command that computes again what a folder holds.
#pragma once

#include <filesystem>
#include <string>

#include "driver/cli/commands.hpp"

namespace kreisel {

/// Computes `count` randomly chosen cells of a folder again and compares their result lines byte for byte;
/// compares every stored reference with the second route.
Exit verify_command(const std::filesystem::path& folder, std::size_t count, unsigned seed, const std::string& build,
                    const Engines& engines, const Terminal& terminal);

}  // namespace kreisel
