// SPDX-License-Identifier: BSD-3-Clause
//
// The command that starts a method, a problem or an experiment.
#pragma once

#include <filesystem>
#include <string>

#include "driver/cli/commands.hpp"

namespace kreisel {

/// Writes the scaffold of that kind and name: into `folder`; else, of a method or problem, to its place in the sources
/// that kreisel was built from, and of an experiment into the current folder. Says what to do next. Throws UsageError
/// for names that cannot be or that there are, and FileError rather than overwrite a file.
Exit new_command(const std::string& kind, const std::string& name, const std::filesystem::path& folder,
                 const Engines& engines, const Terminal& terminal);

}  // namespace kreisel
