// SPDX-License-Identifier: BSD-3-Clause
//
// manifest.json: how the results of a folder were produced, and which files of it are kreisel's. It ends with a sum of
// itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "records/json/diagnostics.hpp"
#include "records/metrics/units.hpp"

namespace kreisel {

/// What newly written folders say under "format". Lines and manifests of older ones need not have a sum.
inline constexpr int folder_format = 2;

/// Numbers of cells by outcome.
struct CellCounts {
    std::size_t total = 0, ok = 0, skipped = 0, failed = 0, missing = 0;
};

/// "manifest.json", or "manifest.<shard>.json".
std::filesystem::path manifest_file(const std::filesystem::path& folder, const std::string& shard);

/// What was run.
struct ManifestSubject {
    std::string name;
    std::vector<std::string> warnings;
    std::string config;  ///< as resolved, JSON
    Units units;         ///< of the metrics
};

/// How far a run has come.
struct ManifestState {
    std::string build;
    std::string started, ended;  ///< UTC; `ended` is empty while the run lasts
    CellCounts counts;
    std::optional<std::uintmax_t> journal;  ///< bytes of its journal when it ended
    std::vector<std::string> files;         ///< that it writes, below the folder
    std::vector<std::string> earlier;       ///< runs whose results it has taken over, as JSON
    std::string plan = "";                  ///< of a part: the digest of the plan it is dealt from
};

/// Throws FileError.
void write_manifest(const std::filesystem::path& file, const ManifestSubject& subject, const ManifestState& state);

/// What is read of a manifest.
struct ManifestContents {
    Document config;      ///< from which the run was made
    ManifestState state;  ///< counts: total and missing only
    int format = 1;
    std::string run;  ///< of this manifest, as later ones keep it under `earlier`
};

/// Throws FileError if the file is damaged, UsageError if it is not a manifest.
ManifestContents read_manifest(const std::filesystem::path& file);

/// The text of a manifest whose sum holds, or that is too old to have one. Throws FileError.
Document read_summed_manifest(const std::filesystem::path& file);

/// The format that the manifests of a folder tell; 1 where there is none that can be read.
int format_of(const std::filesystem::path& folder);

}  // namespace kreisel
