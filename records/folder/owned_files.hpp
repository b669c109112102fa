// SPDX-License-Identifier: BSD-3-Clause
//
// Which files of a results folder are kreisel's: those that its manifests list. All others are never touched.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace kreisel {

/// What a run writes, as its manifest lists it: paths below the folder. Those of samples and references stand as one
/// pattern, "trajectories/*.csv", in which the asterisk is the name of a cell.
std::vector<std::string> files_of_run(const std::string& shard, bool samples, bool references);

class OwnedFiles {
  public:
    /// Of all manifests of a folder; of older versions the names that these have written. Throws FileError if a
    /// manifest is damaged.
    explicit OwnedFiles(const std::filesystem::path& folder) : OwnedFiles(folder, true, "") {}
    /// Of one shard only.
    static OwnedFiles of_shard(const std::filesystem::path& folder, const std::string& shard) {
        return OwnedFiles(folder, false, shard);
    }

    bool empty() const { return files_.empty(); }
    /// As listed.
    const std::vector<std::string>& files() const { return files_; }
    bool has(const std::string& path) const;
    /// Throws UsageError if there is a file, at one of these names below the folder, that is not listed.
    void require(const std::vector<std::string>& paths) const;
    /// Removes results, the samples of the cells that `mine` names, with their parts, and manifests but for the one of
    /// `shard`, which the run that begins replaces: were it killed in between, what is left would be nobody's.
    /// References stay, for they can be used again.
    void remove_results(const std::string& shard, const std::function<bool(const std::string& cell)>& mine) const;

  private:
    OwnedFiles(const std::filesystem::path& folder, bool all, const std::string& shard);

    std::filesystem::path folder_;
    std::vector<std::string> files_;
};

/// Removes the parts of trajectories of those cells that `stale` names.
void remove_parts(const std::filesystem::path& folder, const std::function<bool(const std::string& cell)>& stale);

/// Removes what a killed run has left of files it was about to write whole. No other run may be at work.
void remove_torn_files(const std::filesystem::path& folder, const OwnedFiles& owned);

/// Lists tables and figures that an older version has written, so that they can be replaced.
void adopt_derived_files(const std::filesystem::path& folder);

}  // namespace kreisel
