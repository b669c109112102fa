// SPDX-License-Identifier: BSD-3-Clause
//
// The nearest valid word for a mistyped command or option.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace kreisel {

/// "; did you mean ...?" for the first mistyped word of a command line, the program's name left out; else empty.
std::string suggestion(const CLI::App& app, const std::vector<std::string>& words);

/// Throws UsageError unless `word` is a command.
void require_command(const CLI::App& app, const std::string& word);

}  // namespace kreisel
