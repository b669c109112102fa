// SPDX-License-Identifier: BSD-3-Clause
//
// manifest.json: how the results of a folder were produced.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "records/json/diagnostics.hpp"
#include "records/metrics/units.hpp"

namespace kreisel {

/// Numbers of cells by outcome.
struct CellCounts {
    std::size_t total = 0, ok = 0, skipped = 0, failed = 0, missing = 0;
};

struct ManifestTimes {
    std::string started, ended;  ///< UTC; `ended` is empty while the run lasts
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

/// Throws FileError.
void write_manifest(const std::filesystem::path& file, const ManifestSubject& subject, const std::string& build,
                    const ManifestTimes& times, const CellCounts& counts);

/// What `merge` and `verify` need of a manifest: the config it was made from, as a document, and the build.
struct ManifestContents {
    Document config;
    std::string build;
};

/// Throws UsageError if the file is not a manifest.
ManifestContents read_manifest(const std::filesystem::path& file);

}  // namespace kreisel
