// SPDX-License-Identifier: BSD-3-Clause
//
// The command that says what is installed, what the machine allows, and whether the program computes what it should.
#pragma once

#include <filesystem>

#include "driver/cli/commands.hpp"

namespace kreisel {

/// Prints a line a finding with what to do, or JSON; `folder` is where results are to go, by default results. Exit code
/// 1 where something that is there does not work, results cannot be written, or the self-test fails.
Exit doctor_command(const std::filesystem::path& folder, bool json, const Engines& engines, const Terminal& terminal);

}  // namespace kreisel
