// SPDX-License-Identifier: BSD-3-Clause
//
// `kreisel published`: published numbers beside ours.
#pragma once

#include <filesystem>

#include "driver/cli/commands.hpp"

namespace kreisel {

/// Runs the configs that experiments/published/published.csv names, and prints for each of its values source, what is
/// printed there, what comes out here (of several cells the one that agrees least), and the digits that agree. With an
/// `output` folder writes the table there as Markdown, CSV and LaTeX. Returns Exit::cells_failed if fewer digits agree
/// than the file says. Throws FileError, UsageError.
Exit published_command(const std::filesystem::path& output, const Engines& engines, const Terminal& terminal);

}  // namespace kreisel
