// SPDX-License-Identifier: BSD-3-Clause
//
// The script that runs a plan on a Slurm cluster: settings, then jobs.sh, which the build puts into the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kreisel {

struct ClusterJob {
    std::string name;                       ///< of the config
    std::filesystem::path program, folder;  ///< absolute
    std::size_t parts = 1, references = 0;
    std::vector<std::string> limits;   ///< options of kreisel run
    std::vector<std::string> options;  ///< of sbatch, for all jobs
};

/// Ends in a sum of its own, by which is_submit_script knows it again. `config`: the text of the config beside it.
std::string submit_script(const ClusterJob& job, const std::string& config);

/// Whether a text is such a script as it was written.
bool is_submit_script(const std::string& text);

/// Whether a script was written for this config.
bool is_script_of(const std::string& script, const std::string& config);

}  // namespace kreisel
