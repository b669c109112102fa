// SPDX-License-Identifier: BSD-3-Clause
//
// Commands that ask about methods and configs without running an experiment of the user.
#pragma once

#include "driver/cli/command_line.hpp"

namespace kreisel {

void add_inquiries(CommandLine& line);
/// To `kreisel list`: only some methods.
void add_filter(CommandLine& line, CLI::App& list);

}  // namespace kreisel
