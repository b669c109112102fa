// SPDX-License-Identifier: BSD-3-Clause
//
// Reference solutions kept in the output folder, so that a resumed run need not compute them again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "experiments/plan.hpp"

namespace kreisel {

/// `references/<hash>.json`.
std::filesystem::path reference_file(const std::filesystem::path& folder, const std::string& hash);

/// The stored reference, or nothing if there is none of this content and build, or if it is damaged.
std::optional<Reference> load_reference(const std::filesystem::path& file, const PlannedReference& planned,
                                        const std::string& build);

/// Throws FileError.
void store_reference(const std::filesystem::path& file, const PlannedReference& planned, const Reference& reference,
                     const std::string& build);

}  // namespace kreisel
