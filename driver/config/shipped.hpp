// SPDX-License-Identifier: BSD-3-Clause
//
// The configs that come with kreisel, found by their names.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace kreisel {

/// The folder of these configs: the environment variable KREISEL_EXPERIMENTS, else ../share/kreisel/experiments beside
/// this program, else experiments/ of the sources it was built from. Empty where none exists.
std::filesystem::path shipped_folder();

/// The files NAME.json in `folder` and the folders below it, by NAME. Throws UsageError where two have the same name.
std::map<std::string, std::filesystem::path> configs_below(const std::filesystem::path& folder);

/// The file that `written` means: the file at that path where there is one, else the shipped config of that name.
/// Throws UsageError, with the nearest name, where there is neither, and FileError where `written` is a path (it has a
/// separator or ends in .json) to no file.
std::filesystem::path config_file(const std::filesystem::path& written);

}  // namespace kreisel
