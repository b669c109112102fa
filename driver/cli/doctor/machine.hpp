// SPDX-License-Identifier: BSD-3-Clause
//
// What the machine, and the shell that kreisel was started from, allow.
#pragma once

#include <filesystem>
#include <vector>

#include "driver/cli/doctor/finding.hpp"

namespace kreisel {

/// Instruction set of program and processor, the folder that results are to go to, the locale, and limits.
std::vector<Finding> look_at_machine(const std::filesystem::path& results);

}  // namespace kreisel
