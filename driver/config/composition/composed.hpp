// SPDX-License-Identifier: BSD-3-Clause
//
// Configs made from others: "extends" names the file that a config changes, and settings of the command line change the
// result.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "records/json/diagnostics.hpp"

namespace kreisel {

/// The config in `file`, which may be the manifest of a results folder. Where it has the key "extends", the path of
/// another config relative to its own folder, it is a merge patch of that one (RFC 7396: objects are merged, null
/// removes a key, lists and all else are replaced). Each setting "/POINTER=VALUE" then replaces one value (RFC 6901;
/// "-" appends to a list); VALUE is JSON, or else a text. Parameters from files of their own
/// (mechanism_files.hpp) are then put in their place. Messages about the result point into the file or setting that
/// wrote the value. Throws UsageError on configs that extend each other in a circle and on settings that have no place;
/// FileError on files that cannot be read.
Document composed_config(const std::filesystem::path& file, const std::vector<std::string>& settings = {});

}  // namespace kreisel
