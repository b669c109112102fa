// SPDX-License-Identifier: BSD-3-Clause
//
// The options of kreisel run.
#pragma once

#include "driver/cli/command_line.hpp"

namespace kreisel {

void add_run(CommandLine& line);

}  // namespace kreisel
