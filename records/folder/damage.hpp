// SPDX-License-Identifier: BSD-3-Clause
//
// What is damaged in a results folder, beside the lines of results and journals and the samples.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "records/manifest.hpp"

namespace kreisel {

/// A text for each manifest that is damaged or missing, each reference that is damaged, and for a journal that has
/// become shorter. Throws FileError.
std::vector<std::string> run_damage(const std::filesystem::path& folder);

/// The same, and of lines of journals, results.csv, geometry, tables and figures. Tables and figures that are not there
/// are no damage.
std::vector<std::string> folder_damage(const std::filesystem::path& folder);

/// What is wrong with a line of results.jsonl about a cell that an earlier line is about.
inline constexpr const char* repeated_cell = "damaged: an earlier line is about the same cell";

/// What is wrong with the trajectory of a cell whose result records that sum; empty: nothing. Throws FileError.
std::string trajectory_damage(const std::filesystem::path& folder, const std::string& cell, const std::string& sum);

/// The warning that a folder of an older version deserves.
std::string format_warning(const std::filesystem::path& folder);

/// If a results.jsonl of that many lines is shorter than its manifest says: a text that names the line. Else empty.
std::string missing_lines(const std::filesystem::path& file, std::size_t lines, const ManifestContents& manifest);

}  // namespace kreisel
