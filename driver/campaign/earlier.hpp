// SPDX-License-Identifier: BSD-3-Clause
//
// What a folder holds when a run begins: what is taken over, what is removed, what is refused. Internal to the
// campaign.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "driver/campaign/campaign.hpp"
#include "records/journal.hpp"

namespace kreisel {

/// For the manifest the earlier runs and their files, for the campaign the results.
struct Earlier {
    JournalContents journals;
    std::vector<std::string> runs, files;
    bool damaged = false;  ///< some of it, which was said
};

/// Reads what --resume takes over, or removes what --overwrite does not keep. The folder must be locked.
Earlier earlier_results(const Plan& plan, const std::filesystem::path& folder, const RunSettings& settings,
                        std::ostream& messages);

/// Removes what a killed run has left in parts, where no journal line asks to keep them. Other shards may be at work.
void remove_leftovers(const Plan& plan, const std::filesystem::path& folder, const RunSettings& settings,
                      const JournalContents& journals);

}  // namespace kreisel
