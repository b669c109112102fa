// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the cells of a plan in worker processes into an output folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "driver/plan/plan.hpp"
#include "records/cell/line.hpp"
#include "records/manifest.hpp"

namespace kreisel {

struct RunSettings {
    unsigned workers = 1;
    bool resume = false;
    bool overwrite = false;
    bool references_only = false;       ///< compute what cells are compared with, and no cell
    std::size_t shard = 1, shards = 1;  ///< run the cells that are dealt to this part (plan/shards.hpp)
    std::string build;                  ///< identifies the code; results of another build are never reused
    std::filesystem::path cache;        ///< where references are kept for all results; empty: nowhere
    std::filesystem::path references;   ///< a results folder to take references from; empty: none
    bool terminal = false;              ///< progress as one line that rewrites itself
    double grace = 1;                   ///< s that interrupted workers get to finish before they are killed
    double timeout = 0;                 ///< s of CPU time that a cell may take; 0: any
    std::uint64_t max_memory = 0;       ///< bytes that all cells together may have; 0: 80 % of what there is
};

struct CampaignReport {
    CellCounts counts;
    std::size_t reused = 0;
    std::size_t references = 0;                   ///< that are there
    std::vector<std::string> reference_failures;  ///< one line for each that could not be computed
    double seconds = 0;
    std::vector<std::pair<std::string, std::string>>
        failures;  ///< one line for each failed cell; the second: its status
    bool interrupted = false;
    std::vector<std::filesystem::path> parts;  ///< samples of cells that were interrupted, this time or before
    std::vector<std::string> notes;            ///< on the run, and on cells that are ok, one line each
};

/// How many cells are computed at the same time where nobody says: one on each processor. One where /proc is not
/// mounted: what a cgroup allows and what a worker takes is not known then.
unsigned usual_workers();

/// "", or "I-of-N".
std::string shard_name(const RunSettings& settings);

/// Throws UsageError if the folder holds results and the settings neither resume nor overwrite, if it holds a part of
/// another plan than the one to be written, and if it holds a file, at a name that the run would write, that no
/// manifest in it lists; FileError if a manifest is damaged.
void check_output_folder(const std::filesystem::path& folder, const Plan& plan, const RunSettings& settings);

/// Runs the cells that have no result yet. Writes journal, manifest, results, trajectories and references. Throws
/// FileError on input/output errors; what was journalled before stays valid. No worker outlives it.
/// While it runs, signals are those of an InterruptGuard.
CampaignReport run_campaign(const Plan& plan, const Engines& engines, const std::filesystem::path& folder,
                            const RunSettings& settings, std::ostream& messages);

}  // namespace kreisel
