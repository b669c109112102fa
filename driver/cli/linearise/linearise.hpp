// SPDX-License-Identifier: BSD-3-Clause
//
// `kreisel linearise`: eigenvalues of the motions near the starts of a config's problems.
#pragma once

#include <filesystem>

#include "driver/cli/commands.hpp"

namespace kreisel {

/// Linearises in quad, whatever precisions the config names, every problem in each of its formulations that applies.
/// Prints the steady motion and the eigenvalues; with an `output` folder writes them to linearisation.md, .csv (all
/// digits) and .tex there. Throws UsageError, after all else is printed, that names each start that is neither an
/// equilibrium nor a steady motion.
Exit linearise_command(const std::filesystem::path& config, const std::filesystem::path& output, const Engines& engines,
                       const Terminal& terminal);

}  // namespace kreisel
