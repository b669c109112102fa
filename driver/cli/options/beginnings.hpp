// SPDX-License-Identifier: BSD-3-Clause
//
// Commands for those who begin: is everything there, and a file to start from.
#pragma once

#include "driver/cli/command_line.hpp"

namespace kreisel {

void add_beginnings(CommandLine& line);

}  // namespace kreisel
