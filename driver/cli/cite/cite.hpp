// SPDX-License-Identifier: BSD-3-Clause
//
// `kreisel cite`: the sources of what a config uses, as BibTeX.
#pragma once

#include <filesystem>

#include "driver/cli/commands.hpp"

namespace kreisel {

/// Prints the entries of the methods, projections, problems and formulations of a config in the order of the
/// bibliography, each below a comment that says what it is the source of, and the entries that these cite themselves.
/// Names on `messages` what states no source. Throws UsageError for a config that cannot be read.
Exit cite_command(const std::filesystem::path& config, const Engines& engines, const Terminal& terminal);

}  // namespace kreisel
