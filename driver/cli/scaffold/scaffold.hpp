// SPDX-License-Identifier: BSD-3-Clause
//
// What a new method, problem or experiment starts from: a file that compiles, or runs, as it is.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "driver/config/catalogue.hpp"

namespace kreisel {

struct Scaffold {
    std::filesystem::path place;  ///< below the sources: "methods/rkmk/my3.cpp"; of an experiment "my3.json"
    std::string text;
};

/// "method", "problem" and "experiment".
const std::vector<std::string>& scaffold_kinds();

/// The families that have one.
std::vector<std::string> scaffold_families();

/// The file of a method "family/scheme", a problem or an experiment of that name. Throws UsageError, with the nearest
/// valid family, for a name that cannot be one, and for one that there is.
Scaffold scaffold_of(const std::string& kind, const std::string& name, const Catalogue& catalogue);

}  // namespace kreisel
