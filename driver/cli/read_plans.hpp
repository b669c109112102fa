// SPDX-License-Identifier: BSD-3-Clause
//
// The configs that a command line names, read and planned.
#pragma once

#include "driver/cli/commands.hpp"

namespace kreisel {

/// What the command line names, as files. Throws UsageError with the errors of all.
Paths config_files(const Paths& written);

/// Reads everything before anything runs, and prints warnings. `references`: a results folder that gives a program
/// without quad precision what it cannot compute; empty: none. Throws UsageError with the errors of all files.
std::vector<Plan> read_plans(const Paths& files, const ConfigChanges& changes, const std::filesystem::path& references,
                             const Engines& engines, std::ostream& messages);

}  // namespace kreisel
