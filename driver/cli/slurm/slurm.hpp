// SPDX-License-Identifier: BSD-3-Clause
//
// The command that writes what runs a config on a Slurm cluster.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "driver/cli/commands.hpp"

namespace kreisel {

struct SlurmSettings {
    std::size_t parts = 0;  ///< 0: up to ten
    std::string time;       ///< as Slurm writes it; empty: the cluster's own
    unsigned cpus = 1;      ///< of each job
    double timeout = 0;     ///< of kreisel run
    bool submit = false;
    std::vector<std::string> options;  ///< more of sbatch, for all jobs
};

/// Checks the config and writes it as resolved, with submit.sh, into `folder` (by default results/NAME); submits that
/// if asked to. Throws UsageError also for a folder that holds parts of another plan, or other files at these names.
Exit slurm_command(const std::filesystem::path& config, const ConfigChanges& changes,
                   const std::filesystem::path& folder, const SlurmSettings& settings, const Engines& engines,
                   const Terminal& terminal);

}  // namespace kreisel
