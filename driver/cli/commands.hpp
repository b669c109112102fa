// SPDX-License-Identifier: BSD-3-Clause
//
// The commands of the program. Each prints and returns an exit code; usage and file errors are thrown.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "driver/campaign/campaign.hpp"
#include "driver/config/catalogue.hpp"
#include "support/errors.hpp"

namespace kreisel {

struct Terminal {
    std::ostream& out;
    std::ostream& messages;
};

using Paths = std::vector<std::filesystem::path>;

/// What the command line changes in configs.
struct ConfigChanges {
    std::vector<std::string> settings;  ///< /POINTER=VALUE, see driver/config/composition/composed.hpp
    std::vector<std::string> filters;   ///< AXIS=PATTERN, see driver/config/composition/filter.hpp
};

/// Configs are files, or names of shipped configs (driver/config/shipped.hpp).
/// `references`: see read_plans.hpp.
Exit check_command(const Paths& configs, const ConfigChanges& changes, const std::filesystem::path& references,
                   const Engines& engines, const Terminal& terminal);
Exit plan_command(const std::filesystem::path& config, const ConfigChanges& changes,
                  const std::filesystem::path& references, bool json, const Engines& engines, const Terminal& terminal);

/// Without `output`, each config goes to results/<its name>; with several configs, each to output/<its name>.
Exit run_command(const Paths& configs, const ConfigChanges& changes, const std::filesystem::path& output,
                 const RunSettings& settings, const Engines& engines, const Terminal& terminal);

}  // namespace kreisel
