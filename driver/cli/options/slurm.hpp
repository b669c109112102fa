// SPDX-License-Identifier: BSD-3-Clause
//
// The options of kreisel slurm.
#pragma once

#include "driver/cli/command_line.hpp"

namespace kreisel {

void add_slurm(CommandLine& line);

}  // namespace kreisel
