// SPDX-License-Identifier: BSD-3-Clause
//
// The commands of the program. Each prints and returns how it went; usage and file errors are thrown.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "experiments/campaign.hpp"
#include "experiments/errors.hpp"
#include "experiments/registry.hpp"

namespace kreisel {

struct Terminal {
    std::ostream& out;
    std::ostream& messages;
};

using Paths = std::vector<std::filesystem::path>;

Exit check_command(const Paths& configs, const Engines& engines, const Terminal& terminal);
Exit plan_command(const std::filesystem::path& config, bool json, const Engines& engines, const Terminal& terminal);

/// Without `output`, each config goes to results/<its name>; with several configs, each to output/<its name>.
Exit run_command(const Paths& configs, const std::filesystem::path& output, const RunSettings& settings,
                 const Engines& engines, const Terminal& terminal);

/// Puts the journals of several folders or shards together; the results go to `output`, by default the first folder.
Exit merge_command(const Paths& folders, const std::filesystem::path& output, const std::string& build,
                   const Engines& engines, const Terminal& terminal);

/// Computes `count` randomly chosen cells of a folder again and compares their result lines byte for byte;
/// holds every stored reference against the second route.
Exit verify_command(const std::filesystem::path& folder, std::size_t count, unsigned seed, const std::string& build,
                    const Engines& engines, const Terminal& terminal);

}  // namespace kreisel
